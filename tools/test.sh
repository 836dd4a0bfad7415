#!/usr/bin/env bash
# Installs what is missing, builds Asperity and runs its tests.
# Usage: tools/test.sh [PRESET]   all tests of one preset but those labeled long: release
#                                 (default), dev, asan, tsan, or of one sanitizer gate: asan-gate,
#                                 tsan-gate
#        tools/test.sh gates      all gates in one run: what changed compiled source by source; the release
#                                 tests; readers, tick and maps with AddressSanitizer and UBSan, and
#                                 14 s of each fuzzer; loop, recording and devices with ThreadSanitizer
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
wanted=${1:-release}

# Runs a command and says how long it took.
stage() {
    local name=$1 begin=$SECONDS
    shift
    "$@"
    echo "== $name: $((SECONDS - begin)) s"
}

# skip_reasons OUTPUT LOG: prints why CTest's own tests were skipped, which its output does not say.
skip_reasons() {
    awk 'NR == FNR { if (/[*][*][*]Skipped/) skipped[$4]; next }
         / Testing: / { name = $3 }
         /^Output:$/ && name in skipped { getline; getline; print "SKIPPED " name ": " $0 }' "$@"
}

# run_tests PRESETS FOLDER ARGUMENT ...: runs ctest in a folder of build/, counts the test functions that ran, and
# ends with CTest's summary.
run_tests() {
    local preset results=() status=0 log=$top/build/tests.log begin=$SECONDS
    for preset in $1; do
        results+=("$top/build/$preset/results")
    done
    rm -rf "${results[@]}"
    ctest --test-dir "$top/build/$2" --output-on-failure --no-tests=error -j3 "${@:3}" | tee "$log" || status=$?
    echo "== running the tests: $((SECONDS - begin)) s"
    skip_reasons "$log" "$top/build/$2/Testing/Temporary/LastTest.log"
    "$top/tools/gtest_results.py" "${results[@]}" || status=1
    sed -n '/tests passed, .* tests failed/,$p' "$log"
    return "$status"
}

packages=()
case $wanted in
release | dev) ;;
*) packages=("$top/tools/gate_packages.txt") ;;
esac
stage "installing packages" "$top/tools/install_packages.sh" "${packages[@]}"

cd "$top"
if [ "$wanted" != gates ]; then
    target=all
    case $wanted in asan-gate | tsan-gate) target=asperity_gate ;; esac
    stage "building $wanted" "$top/tools/build.sh" "$wanted" "$target"
    run_tests "$wanted" "$wanted" --label-exclude '^long$'
    exit
fi

# A gate that cannot be configured is told before the first one is built. Warnings are errors in the gates,
# not in a user's build.
configure() {
    cmake --preset release --log-level=WARNING -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
    for preset in dev asan-gate tsan-gate; do
        cmake --preset "$preset" --log-level=WARNING
    done
}
stage "configuring the gates" configure
stage "sources alone" "$top/tools/compile_alone.py" "$top/build/dev"
stage "building release" "$top/tools/build.sh" release
stage "building benchmarks, pictures" "$top/tools/build.sh" release asperity_benchmarks asperity_picture_tools
stage "building asan-gate" "$top/tools/build.sh" asan-gate asperity_gate
stage "building tsan-gate" "$top/tools/build.sh" tsan-gate asperity_gate

# One run and one summary for all of them. What they check must not be skipped.
export ASPERITY_GATES=1
gates=$top/build/gates
mkdir -p "$gates"
for preset in release asan-gate tsan-gate; do
    echo "subdirs(\"$top/build/$preset\")"
done >"$gates/CTestTestfile.cmake"
# Only programs of listed packages: a missing line of the lists fails here, not on a fresh machine.
listed=$("$top/tools/listed_path.py" "$top/build/listed" "$top"/tools/{packages,gate_packages}.txt)
PATH=$listed run_tests "release asan-gate tsan-gate" gates --label-exclude '^long$'
