#!/usr/bin/env bash
# The tests of core, io, sequences and result pictures under the sanitizers of addresses and undefined behaviour;
# a build of its own, two hours or so on two cores.
#   packaging/sanitize.sh           all but the slow ones
#   packaging/sanitize.sh [SPEC]    those of a Catch2 specification, e.g. "[handles]"
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test
configure asan
cmake --build --preset asan -j "$(nproc)" --target core_tests io_tests sequence_tests result_picture_tests
export UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS="suppressions=$PWD/packaging/leaks.supp:print_suppressions=0"
for program in core_tests io/io_tests sequence/sequence_tests app/result_picture_tests; do
  program=build/asan/tests/$program
  # Catch2 3 calls it a fault if a program has none of them; 2 does not know the option.
  options=()
  if [[ $("$program" --help) == *allow-running-no-tests* ]]; then options=(--allow-running-no-tests); fi
  "$program" "${options[@]}" "${1:-~[.]}"
done
