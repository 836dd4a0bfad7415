#!/usr/bin/env bash
# Sets ParaView up (install_paraview.sh), builds the plugin for it (docs/paraview.md), where it is
# not built already, and says where it is.
# With a command as arguments, runs that instead, with ParaView in the PATH and the plugin's file in
# ASPERITY_PLUGIN: tools/build_paraview.sh pvbatch SCRIPT.py
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$top/tools/install_packages.sh"
"$top/tools/install_paraview.sh"

paraview=$top/build/paraview
root=$paraview/root/usr
export PATH=$root/bin:$PATH
export LD_LIBRARY_PATH=$root/lib/x86_64-linux-gnu${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PYTHONPATH=$root/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
if [ ! -f "$paraview/plugin/build.ninja" ]; then
    # ParaView's Python is Debian's, whatever other one comes first.
    cmake -G Ninja -S "$top/vtkplugins/paraview" -B "$paraview/plugin" --log-level=WARNING \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$root" \
        -DPython3_EXECUTABLE=/usr/bin/python3
fi
log=$paraview/build.log
cmake --build "$paraview/plugin" >"$log" || { tail -n 40 "$log" >&2; exit 1; }
ASPERITY_PLUGIN=$(find "$paraview/plugin" -name AsperityPlugin.so)
export ASPERITY_PLUGIN
if [ $# -gt 0 ]; then
    exec "$@"
fi
echo "${ASPERITY_PLUGIN#"$top/"}"
