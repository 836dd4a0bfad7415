#!/usr/bin/env bash
# Installs the programs that tests and benchmarks compare Asperity with where they are present.
# None of them is needed or linked into the product: without them these comparisons are skipped.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
exec "$here/install_packages.sh" "$here/peers.txt"
