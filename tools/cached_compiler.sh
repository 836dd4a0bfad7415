#!/usr/bin/env bash
# Runs a compiler through ccache, by paths relative to the build folder: so what one checkout
# compiled serves the next one. ccache's own base_dir leaves the paths behind -Xclang.
# Usage: tools/cached_compiler.sh COMPILER [ARGUMENT ...], in a build folder of this checkout
set -euo pipefail
top=${BASH_SOURCE[0]%/tools/*}
up=$(realpath --relative-to=. "$top")

command=()
for argument in "$@"; do
    case $argument in
    -DQT_TESTCASE_*DIR=*) ;; # Qt's, of the checkout's own path: no test here asks for it
    # VTK's, a header: it is found from the checkout's top folder, too.
    -D*_AUTOINIT_INCLUDE=*) command+=("${argument//"$top/"/}") ;;
    -D*) command+=("$argument") ;;
    "$top"/* | -[A-Z]"$top" | -[A-Z]"$top"/* | -*="$top"/*) command+=("${argument/"$top"/"$up"}") ;;
    *) command+=("$argument") ;; # a path inside of another one, too
    esac
done

# Without the sloppiness ccache does not keep what is compiled from precompiled headers. It reads
# them, 150 to 270 MB each, for every source file if it may not remember what it read (CCACHE_INODECACHE).
export CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_PCH_EXTSUM=1 CCACHE_INODECACHE=1
export CCACHE_EXTRAFILES=$top/tools/sanitizer_ignorelist.txt
if [[ " ${command[*]} " != *" -emit-pch "* ]]; then
    exec ccache "${command[@]}"
fi

# clang's precompiled headers tell the checkout's own path, so that they serve no other one. Each
# is compiled again, and ccache knows it by what it was compiled from.
"${command[@]}"
for ((i = 0; i < ${#command[@]}; ++i)); do
    case ${command[i]} in
    -o) header=${command[i + 1]} ;;
    -MF) sources=${command[i + 1]} ;;
    esac
done
{
    "$1" --version
    printf '%s\n' "${command[@]}"
    sed 's/^[^:]*://; s/\\$//' "$sources" | xargs cat
} | sha256sum >"$header.sum"
