#!/usr/bin/env bash
# Runs the fuzzers of the readers from the corpus and the real files on, two at a time, and lists
# seconds, executions and findings of each. Build them first: tools/build.sh asan asperity_fuzz
# Usage: tools/fuzz_readers.sh SECONDS [FORMAT...]   seconds of each; all formats by default
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seconds=${1:?usage: tools/fuzz_readers.sh SECONDS [FORMAT...]}
shift
export top seconds
export programs=$top/build/asan/bin
export work=$top/build/asan/fuzz_readers  # inputs found, logs, inputs that break a reader

# As in tests/fuzz/CMakeLists.txt: -rss_limit_mb is for what a reader holds, not for what it freed.
export ASAN_OPTIONS=quarantine_size_mb=16

# The real files that a reader takes.
real_files() {
    case $1 in
    igorcurve) echo "../curves/original/*.ibw" ;;
    jpkcurve) echo "../curves/original/*.jpk-*" ;;
    nanoscopecurve) echo "../curves/original/*.spm" ;;
    nanosurfcurve) echo "../curves/original/*.nid" ;;
    ntmdttextcurve) echo "../curves/original/fmt-ntmdt*" ;;
    textcurve) echo "../curves/original/*.csv" ;;
    zippedtextcurve) echo "../curves/original/*.zip" ;;
    exr | gsf) echo "derived/*.$1" ;;
    gwy) echo "gwy/* derived/*.gwy" ;;
    jpk) echo "jpk/*-image jpk/*.jpk" ;;
    jpkarchive) echo "jpk/*-data" ;;
    nanoscopetext) echo "cases/nanoscope_analysis*" ;;
    nanosurf) echo "nid/*" ;;
    picoview) echo "mi/*" ;;
    png) echo "derived/*.png" ;;
    tiff) echo "derived/*.tif park/*" ;;
    xyz) echo "text/xyz-*" ;;
    bcr | igor | nanonis | nanoscope | park | sdf | text | wsxm | x3p) echo "$1/*" ;;
    esac
}
export -f real_files

fuzz() {
    local format=$1 folder=$work/$1
    mkdir -p "$folder/seeds" "$folder/found"
    local data=$top/../shared/data/afm
    for pattern in $(set -f; real_files "$format"); do
        cp --no-preserve=mode "$data"/$pattern "$folder/seeds"
    done
    nice -n 15 "$programs/asperity_fuzz_$format" -max_total_time="$seconds" -timeout=20 \
        -rss_limit_mb=300 -print_final_stats=1 -artifact_prefix="$folder/" "$folder/found" \
        "$folder/seeds" "$top/tests/fuzz/corpus/$format" >"$folder/log" 2>&1 || true
    printf '%-12s %6s s %10s executions  %s\n' "$format" \
        "$(sed -n 's/^Done .* in \(.*\) second.*/\1/p' "$folder/log")" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log")" \
        "$(find "$folder" -maxdepth 1 -name '*-*' -printf '%f ' | grep . || echo 'no finding')"
}
export -f fuzz

formats=("$@")
if [ ${#formats[@]} -eq 0 ]; then
    for program in "$programs"/asperity_fuzz_*; do
        formats+=("${program##*asperity_fuzz_}")
    done
fi
mkdir -p "$work"
printf '%s\n' "${formats[@]}" | xargs -P 2 -I{} bash -c 'fuzz {}'
