#!/usr/bin/env bash
# Builds the Debian package for this release of Debian: packaging/deb.sh [FOLDER], default ./handlebody-package
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
output=${1:-handlebody-package}
mkdir -p "$output"
output=$(cd "$output" && pwd)
cd "$root"
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build package
configure release -B build/package -DBUILD_TESTING=OFF
cmake --build build/package -j "$(nproc)"
(cd build/package && cpack -G DEB -B "$output")
rm -rf "$output/_CPack_Packages"
ls -l "$output"/*.deb
