#!/usr/bin/env bash
# Says which lines of the product its tests run: a table of each folder, and a page of each source in
# build/coverage/report.
# Usage: tools/coverage.sh [TEST_PROGRAM ...]   of all tests but those labeled long; or of these
#                                               programs alone, as asperity_scene_tests
# Needs tools/install_packages.sh tools/developer_packages.txt
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$top/build/coverage
command -v gcovr >/dev/null || {
    echo "coverage.sh: gcovr is missing: tools/install_packages.sh tools/developer_packages.txt" >&2
    exit 1
}
# Not optimized: a line that the optimizer moved counts for another. Source by source, so that each has its own counts.
cmake -S "$top" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS="--coverage -fprofile-update=atomic" --log-level=WARNING
cmake --build "$build" --target "${@:-all}"
chosen=()
for program in "$@"; do
    name=${program#asperity_}
    chosen+=("^${name%_tests}([.]|\$)")
done
find "$build" -name '*.gcda' -delete
status=0
ctest --test-dir "$build" -j2 --label-exclude '^long$' --output-on-failure \
    --tests-regex "$(IFS='|' && echo "${chosen[*]:-.}")" || status=$?
mkdir -p "$build/report"
gcovr --root "$top" --object-directory "$build" --filter "$top/(app|core|hardware|ui|vtkplugins)/" \
    --print-summary --html-details "$build/report/index.html" "$build"/{app,core,hardware,tests,ui,vtkplugins} |
    tee "$build/report/summary.txt"
exit "$status"
