#!/usr/bin/env bash
# From a fresh Debian (git, apt, root or sudo) to a test run: installs what is missing, builds, runs all tests.
# Arguments go to ctest, e.g. `-LE slow` leaves the slow tests out.
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test
configure dev
cmake --build --preset dev -j "$(nproc)"
# The limit is for tests that do not set their own.
# One more than there are cores: some tests wait for other programs.
ctest --preset dev -j "$(($(nproc) + 1))" --timeout 600 "$@"
