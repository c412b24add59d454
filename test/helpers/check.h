// SPDX-License-Identifier: GPL-3.0-or-later
// What must be true of every result, good or bad.

#ifndef TEST_HELPERS_CHECK_H
#define TEST_HELPERS_CHECK_H

#include "helpers/certificate.h"
#include "helpers/solve.h"

#include <string>

namespace test {

/// Is `number` in `text` as a word of its own?
bool mentions(const std::string& text, std::size_t number);

/// Every figure of the certificate against the independent one, and the verdict against the figures.
/// `settings` are those of the run; its energy is exact to `energy_tolerance`, relatively.
void check_certificate(const Result& result, const Soup& soup, const Sphere& sphere, const Settings& settings,
                       double energy_tolerance = 1e-10);

} // namespace test

#endif // TEST_HELPERS_CHECK_H
