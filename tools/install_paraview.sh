#!/usr/bin/env bash
# Sets up ParaView 5.11 for the plugin (docs/paraview.md): downloads Debian's packages and unpacks them
# in build/paraview, beside the builds. Nothing is installed and no root is needed: the package
# python3-paraview conflicts with python3-vtk9, which the build needs. Does nothing when done already.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
place=$top/build/paraview
[ ! -f "$place/root/complete" ] || exit 0

echo "Unpacking ParaView in $place: 83 MB to download, 670 MB on the disk" >&2
rm -rf "$place/root" "$place/packages"
mkdir -p "$place/root" "$place/packages"
cd "$place/packages"
# Root need not become another user for it, who could not write here.
apt-get -qq -o APT::Sandbox::User=root download paraview python3-paraview paraview-dev || {
    echo "ParaView cannot be downloaded: is there a network, and did apt-get update ever run?" >&2
    exit 1
}
for package in *.deb; do
    dpkg -x "$package" "$place/root"
done
rm -r "$place/packages"
touch "$place/root/complete"
