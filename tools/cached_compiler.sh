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

# Depend mode: the compiler's own list of headers says what an object was made from, so that nothing is
# preprocessed once more to find out.
export CCACHE_DEPEND=1 CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros CCACHE_INODECACHE=1
export CCACHE_EXTRAFILES=$top/tools/sanitizer_ignorelist.txt
exec ccache "${command[@]}"
