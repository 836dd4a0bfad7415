#!/usr/bin/env bash
# Installs what is missing, builds Asperity and runs its tests.
# Usage: tools/test.sh [PRESET]   all tests of one preset but those labeled long: release
#                                 (default), dev, asan, tsan, or of one sanitizer gate: asan-gate,
#                                 tsan-gate
#        tools/test.sh gates      the three gates in one run: the release tests; readers, tick and maps
#                                 with AddressSanitizer and UBSan, and 15 s of each fuzzer;
#                                 loop, recording and devices with ThreadSanitizer
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
wanted=${1:-release}

# The tests that draw need a display; a virtual one gives the same pictures everywhere.
with_display() {
    xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$@"
}

packages=()
case $wanted in
release | dev) ;;
*) packages=("$top/tools/gate_packages.txt") ;;
esac
"$top/tools/install_packages.sh" "${packages[@]}"

cd "$top"
if [ "$wanted" != gates ]; then
    target=all
    case $wanted in asan-gate | tsan-gate) target=asperity_gate ;; esac
    "$top/tools/build.sh" "$wanted" "$target"
    with_display ctest --preset "$wanted" -j2
    exit
fi

# A gate that cannot be configured is told before the first one is built.
for preset in release asan-gate tsan-gate; do
    cmake --preset "$preset" --log-level=WARNING
done
"$top/tools/build.sh" release
"$top/tools/build.sh" asan-gate asperity_gate
"$top/tools/build.sh" tsan-gate asperity_gate

# One run and one summary for all of them. What they check must not be skipped.
export ASPERITY_GATES=1
gates=$top/build/gates
mkdir -p "$gates"
for preset in release asan-gate tsan-gate; do
    echo "subdirs(\"$top/build/$preset\")"
done >"$gates/CTestTestfile.cmake"
# Only programs of listed packages: a missing line of the lists fails here, not on a fresh machine.
listed=$("$top/tools/listed_path.py" "$top/build/listed" "$top"/tools/{packages,gate_packages}.txt)
PATH=$listed with_display ctest --test-dir "$gates" --output-on-failure --no-tests=error -j2 --label-exclude '^long$'
