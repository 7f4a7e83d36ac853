#!/usr/bin/env bash
# Which lines of core its tests and those of io run; a build of its own, an hour or so.
# Fails below 95 % of core's lines. What no test runs: build/coverage/core.html
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test coverage
configure coverage
cmake --build --preset coverage -j "$(nproc)" --target core_tests io_tests
find build/coverage -name '*.gcda' -delete
for program in core_tests io/io_tests; do
  "build/coverage/tests/$program"
done
gcovr --root . --object-directory build/coverage --filter 'core/' --exclude-throw-branches \
  --html-details build/coverage/core.html --print-summary --fail-under-line 95 build/coverage
