#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# serve.sh [PORT]
# From a fresh clone to the page: installs what it needs, builds it, and serves it on this machine.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
"$here/install_dependencies.sh"
node "$here/build.mjs"
exec node "$here/serve.mjs" "$@"
