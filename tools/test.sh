#!/usr/bin/env bash
# Installs what is missing, builds Asperity and runs its tests.
# Usage: tools/test.sh [PRESET]        release (default), dev, asan or tsan
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}

"$top/tools/install_packages.sh"
"$top/tools/build.sh" "$preset"

cd "$top"
# The tests that draw need a display; a virtual one gives the same pictures everywhere.
xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" ctest --preset "$preset" -j2
