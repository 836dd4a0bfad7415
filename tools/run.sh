#!/usr/bin/env bash
# Installs what is missing, builds Asperity and does its main job on a scan: the live window where
# there is a display, else a scripted run with pictures, fields and a force log in out/.
# Usage: tools/run.sh [FILE or SCENE.toml]        default: the window's last session or its demonstration; without a
#                                                 display data/scenes/granular_film.toml
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$top/tools/install_packages.sh"
"$top/tools/build.sh" release asperity

if [ -n "${DISPLAY:-}" ]; then
    exec "$top/build/release/bin/asperity" "$@"
fi
"$top/build/release/bin/asperity" explore "${1:-$top/data/scenes/granular_film.toml}" --out "$PWD/out"
