#!/usr/bin/env bash
# Installs what is missing, builds Asperity and does its main job on a scan.
# Usage: tools/run.sh [FILE or SCENE.toml]        default: data/scenes/polystyrene.toml
# Leaves pictures, fields and a force log in out/.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$top/tools/install_packages.sh"
"$top/tools/build.sh" release asperity

input=${1:-$top/data/scenes/polystyrene.toml}
out=$PWD/out
"$top/build/release/bin/asperity" explore "$input" --out "$out"
