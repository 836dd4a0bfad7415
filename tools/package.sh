#!/usr/bin/env bash
# Builds Asperity and packs it: build/release/asperity_VERSION_ARCHITECTURE.deb.
# `apt install ./FILE` installs it on any Debian 12 machine, `apt remove asperity` leaves nothing.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$top/tools/install_packages.sh" "$top/tools/packaging_packages.txt"
"$top/tools/build.sh" release
umask 022  # what is packed has these rights
cd "$top/build/release"
cpack -B "$PWD" >/dev/null
ls "$PWD"/asperity_*.deb
