#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages, builds everything in build/ and runs all tests.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install_dependencies.sh" --all
"$root/web/install_dependencies.sh" || echo "run_tests.sh: the tests of the page will be skipped" >&2
# a build of before the packages were there has none of these
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_SP_BUILD_TESTING=ON -DCGAL_SP_WITH_PYTHON=ON \
  -DCGAL_SP_WITH_TBB=ON -DCGAL_SP_WITH_OPENCL=ON
cmake --build "$root/build" --parallel "$(nproc)"
cd "$root/build"
ctest --output-on-failure --no-tests=error -j2 </dev/null
