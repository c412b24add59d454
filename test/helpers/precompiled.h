// SPDX-License-Identifier: GPL-3.0-or-later
// What nearly every test includes, precompiled once for all of them. Not the package: what g++ instantiates for its
// inline functions it would do anew in every test. Tests include what they use all the same, so that they compile
// without precompiled headers (CMAKE_DISABLE_PRECOMPILE_HEADERS), too.

#ifndef TEST_HELPERS_PRECOMPILED_H
#define TEST_HELPERS_PRECOMPILED_H

#include "helpers/certificate.h"
#include "helpers/policies.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"
#include "helpers/soup.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#endif // TEST_HELPERS_PRECOMPILED_H
