#!/usr/bin/env bash
# Makes pictures in docs/pictures anew: of the live window, from the scene that comes with the
# program, or from the scan named, in both window sizes of docs/window.md, of its fidelity panel and
# with the simulated device;
# and of deformed surfaces, docs/deformation.md, on samples made up for them.
# Usage: tools/screenshots.sh [FILE or SCENE.toml [OUT_FOLDER]]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

input=${1:-$top/data/scenes/granular_film.toml}
out=${2:-$top/docs/pictures}
command -v pngquant >/dev/null || {
    echo "screenshots.sh: no pngquant; tools/install_packages.sh tools/developer_packages.txt installs it" >&2
    exit 1
}
"$top/tools/build.sh" release asperity_screenshots asperity_deformation_pictures asperity_fidelity_picture \
    asperity_device_picture
unset DISPLAY  # the window's size must not depend on a window manager: it starts its own Xvfb
for size in "1600 1000" "1280 800"; do
    read -r width height <<<"$size"
    "$top/build/release/bin/asperity_screenshots" "$input" "$width" "$height" "$out/window_${width}_"
    pngquant --force --ext .png --speed 1 --quality 80-100 "$out/window_${width}_"*.png
done
"$top/build/release/bin/asperity_fidelity_picture" "$input" "$out/fidelity.png"
pngquant --force --ext .png --speed 1 --quality 80-100 "$out/fidelity.png"
"$top/build/release/bin/asperity_device_picture" "$input" 1280 800 "$out/device.png"
pngquant --force --ext .png --speed 1 --quality 80-100 "$out/device.png"
"$top/build/release/bin/asperity_deformation_pictures" "$out"
