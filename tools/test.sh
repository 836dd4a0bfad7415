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

# run_tests PRESETS ARGUMENT ...: runs ctest, then counts the test functions that ran.
run_tests() {
    local preset results=() status=0
    for preset in $1; do
        results+=("$top/build/$preset/results")
    done
    rm -rf "${results[@]}"
    ctest "${@:2}" || status=$?
    "$top/tools/gtest_results.py" "${results[@]}" || status=1
    return "$status"
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
    run_tests "$wanted" --preset "$wanted" -j2
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
run_tests "release asan-gate tsan-gate" \
    --test-dir "$gates" --output-on-failure --no-tests=error -j2 --label-exclude '^long$'
