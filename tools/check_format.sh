#!/usr/bin/env bash
# Fails where a source is not as clang-format leaves it (.clang-format); says where.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
find core examples vtkplugins hardware ui app bench tools tests cmake \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
    xargs -0 -P 2 -n 100 clang-format --dry-run -Werror
