#!/usr/bin/env bash
# Fails where a source is not as clang-format leaves it (.clang-format); says where. Without
# clang-format it fails in a run of the gates (tools/test.sh), and is skipped elsewhere (77).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if ! command -v clang-format >/dev/null; then
    echo "The format is not checked: clang-format is missing (tools/gate_packages.txt)."
    [ -n "${ASPERITY_GATES:-}" ] && exit 1 || exit 77
fi
find core examples vtkplugins hardware ui app bench tools tests cmake \
    -regextype posix-extended -regex '.*\.(h|hpp|inl|c|cc|cpp|cxx)' -print0 |
    xargs -0 -P 2 -n 100 clang-format --dry-run -Werror
