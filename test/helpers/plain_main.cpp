// SPDX-License-Identifier: GPL-3.0-or-later
// Catch's main() for tests that compute no maps.

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
