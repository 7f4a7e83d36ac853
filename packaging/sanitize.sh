#!/usr/bin/env bash
# The tests of core and io under the sanitizers of addresses and undefined behaviour; a build of its own, an hour or so.
#   packaging/sanitize.sh           all but the slow ones
#   packaging/sanitize.sh [SPEC]    those of a Catch2 specification, e.g. "[handles]"
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test
configure asan
cmake --build --preset asan -j "$(nproc)" --target core_tests io_tests
export UBSAN_OPTIONS=print_stacktrace=1
for program in core_tests io/io_tests; do
  "build/asan/tests/$program" --allow-running-no-tests "${1:-~[.]}"
done
