#!/usr/bin/env bash
# Which lines of core run in the tests of core, io, sequences and the command line; a build of its own, an hour or two.
# The cases of a batch count, and what a decoding child runs up to its answer.
# Fails below 95 % of core's lines. What no test runs: build/coverage/core.html
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test coverage
configure coverage
cmake --build --preset coverage -j "$(nproc)" --target core_tests io_tests sequence_tests cli_tests batch_time_tests result_picture_tests
find build/coverage -name '*.gcda' -delete
for program in core_tests io/io_tests sequence/sequence_tests app/cli_tests app/batch_time_tests app/result_picture_tests; do
  "build/coverage/tests/$program"
done
gcovr --root . --object-directory build/coverage --filter 'core/' --exclude-throw-branches \
  --html-details build/coverage/core.html --print-summary --fail-under-line 95 build/coverage
