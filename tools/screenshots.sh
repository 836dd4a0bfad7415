#!/usr/bin/env bash
# Makes the pictures of docs/pictures again: of the live window, from the scene that comes with the
# program, or from the scan named, in both window sizes of docs/window.md, of its fidelity panel and
# with the simulated device; of the first window, measuring, dark, and on a large screen; of cycles;
# of deformed surfaces, docs/deformation.md, on samples made up for them; and, where ../shared/data is beside the
# checkout, of the measured force curves of docs/measured.md.
# Usage: tools/screenshots.sh [FILE or SCENE.toml [OUT_FOLDER]]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

input=${1:-$top/data/scenes/granular_film.toml}
out=${2:-$top/docs/pictures}
for program in pngquant montage; do
    command -v $program >/dev/null || {
        echo "screenshots.sh: no $program; tools/install_packages.sh tools/developer_packages.txt installs it" >&2
        exit 1
    }
done
"$top/tools/build.sh" release asperity asperity_screenshots asperity_deformation_pictures asperity_fidelity_picture \
    asperity_device_picture asperity_window_picture asperity_open_picture
moments=$(mktemp -d)
trap 'rm -r "$moments"' EXIT
unset DISPLAY  # the window's size must not depend on a window manager: it starts its own Xvfb
for size in "1600 1000" "1280 800"; do
    read -r width height <<<"$size"
    "$top/build/release/bin/asperity_screenshots" "$input" "$width" "$height" "$moments/"
    for moment in indenting retracting; do
        mv "$moments/$moment.png" "$out/window_${width}_$moment.png"
    done
    pngquant --force --ext .png --speed 1 --quality 80-100 "$out/window_${width}_"*.png
done
# The whole cycle on three materials, side by side, on a small, a usual and a large screen of small pixels.
cycle() {  # MATERIAL WIDTH HEIGHT SCALE NAME
    xvfb-run -a -s "-screen 0 $(($2 * $4))x$(($3 * $4))x24 -noreset" env "QT_SCALE_FACTOR=$4" \
        "$top/build/release/bin/asperity_screenshots" "$top/data/scenes/$1.toml" "$2" "$3" "$moments/"
    montage "$moments/"{far,snapped_in,indenting,retracting,off}.png -tile 2x -geometry 1280x+6+6 "$out/cycle_$1_$5.png"
    pngquant --force --ext .png --speed 1 --quality 80-100 "$out/cycle_$1_$5.png"
}
for material in polystyrene silicon_oxide silicone_rubber; do
    cycle "$material" 1280 800 1 1280
    cycle "$material" 1920 1080 1 1920
    cycle "$material" 1920 1080 2 4k
done
# What README shows of one run.
"$top/build/release/bin/asperity" explore "$input" --out "$moments/run" >/dev/null
cp "$moments"/run/{deformation,overview,forces}.png "$out"
"$top/build/release/bin/asperity_fidelity_picture" "$input" "$out/fidelity.png"
pngquant --force --ext .png --speed 1 --quality 80-100 "$out/fidelity.png"
"$top/build/release/bin/asperity_device_picture" "$input" 1280 800 "$out/device.png"
pngquant --force --ext .png --speed 1 --quality 80-100 "$out/device.png"
mkdir "$moments/home"
cp -r "$top/data/." "$moments/home"  # the dialog shows its folders
HOME=$moments/home "$top/build/release/bin/asperity_open_picture" "$moments/home/scenes/granular_film.toml" \
    "$out/open_dialog.png" part
pngquant --force --ext .png --speed 1 --quality 80-100 "$out/open_dialog.png"
# What a user comes by: the first window, measuring, in the dark, on a large screen of small pixels.
state() {  # STATE SAMPLE WIDTH HEIGHT SCALE NAME [dark]
    xvfb-run -a -s "-screen 0 $(($3 * $5))x$(($4 * $5))x24 -noreset" env "QT_SCALE_FACTOR=$5" \
        "$top/build/release/bin/asperity_window_picture" \
        "$1" "$top/data/samples/$2.gsf" "$3" "$4" "$out/$6.png" "${@:7}"
    pngquant --force --ext .png --speed 1 --quality 70-95 "$out/$6.png"
}
state profile grating 1280 800 1 window_profile
for name in start roughness touches map path scene haptics; do
    state "$name" granular_film 1280 800 1 "window_$name"
done
state section granular_film 1280 800 1 window_dark dark
state section granular_film 1920 1080 2 window_4k dark
"$top/build/release/bin/asperity_deformation_pictures" "$out"

# Measured curves with their fits, in sheets.
curves=$top/../shared/data/curves/original
[ -d "$curves" ] || exit 0
mkdir "$moments/fits"
fit() {  # NAME FILE OPTION ...; files are drawn in the order of their names
    "$top/build/release/bin/asperity" fit "$curves/$2" "${@:3}" --out "$moments/fit_$1" >/dev/null
    convert "$moments/fit_$1/fit.png" -resize 800x -set label "$1: ${2#fmt-*_} ${*:3}" "$moments/fits/$1.png"
}
sheet() {  # NAME: of all fits since the last one
    montage "$moments"/fits/*.png -tile 2x -geometry +4+4 -font DejaVu-Sans -pointsize 14 "$out/measured_$1.png"
    pngquant --force --ext .png --speed 1 --quality 70-95 "$out/measured_$1.png"
    rm -r "$moments"/fit_* "$moments"/fits/*.png
}
bead=(--tip paraboloid:18.64um)
moving=(--relaxation on --drag on)
map=fmt-jpk-fd_map-data-reference-points.jpk-force-map
fit a "$map" --tip sphere:18.64um
fit b "$map" "${bead[@]}" --law jkr
fit c "$map" "${bead[@]}" "${moving[@]}"
fit d "$map" --index 1 --tip sphere:18.64um
fit e "$map" --index 1 "${bead[@]}" "${moving[@]}"
flipped=fmt-jpk-fd_flipsign_2015.05.22-15.31.49.352.jpk-force
fit f "$flipped" --tip sphere:10um
fit g "$flipped" "${bead[@]}" "${moving[@]}"
gel=fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force
fit h "$gel" --tip sphere:18.64um
fit i "$gel" --tip sphere:18.64um --law jkr --adhesion two
tissue=fmt-chiaro-txt_AEBP1_Indentation_002.zip
fit j "$tissue" --tip sphere:27.5um
fit k "$tissue" --tip paraboloid:27.5um "${moving[@]}"
sheet beads
fit a fmt-jpk-fd_spot3-0192.jpk-force --tip cone:30deg
fit b fmt-jpk-fd_qi-data-2021.04.13.jpk-qi-series --tip cone:20deg
fit c 20200904_Egel4-Z1.0_00025.spm --tip pyramid4:20deg
fit d 20200903_Egel2.0_00023.spm --tip pyramid4:20deg
fit e 20200903_Egel2.0_00023.spm --index 100 --tip pyramid4:20deg
fit f fmt-igor-fd_U3_3_p10004.ibw --law jkr
nitride=(fmt-igor-fd_SiN_FD_plot.ibw --tip paraboloid:10nm --nu 0.27 --law md)
fit g "${nitride[@]}"
fit h "${nitride[@]}" --lever thermal
fit i "${nitride[@]}" --lever thermal --branch retract
sheet tips
letters=(a b c d e f g h)
for number in 0140 0141 0142 0147 0148 0150 0151 0152; do
    fit "${letters[0]}" "X60_3_x4_$number.ibw"
    letters=("${letters[@]:1}")
done
sheet map
