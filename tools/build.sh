#!/usr/bin/env bash
# Configures, where that was not done for these presets, and builds one preset: everything, or only the targets named.
# Usage: build.sh PRESET [TARGET ...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=$1
shift
[ "build/$preset/build.ninja" -nt CMakePresets.json ] || cmake --preset "$preset" --log-level=WARNING
# More compilers than cores take longer: each holds some hundred megabytes that it reads again and again.
cmake --build "build/$preset" --parallel "$(nproc)" --target "${@:-all}"
