#!/usr/bin/env bash
# Which lines of core run in the tests of core, io, sequences and the command line; a build of its own, an hour.
# The cases of a batch count, and what a decoding child runs up to its answer.
# Fails below 95 % of core's lines. What no test runs: build/coverage/core.html
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build test coverage
configure coverage
programs="core_tests io_tests sequence_tests cli_tests batch_time_tests result_picture_tests"
# shellcheck disable=SC2086
cmake --build --preset coverage -j "$(nproc)" --target $programs
find build/coverage -name '*.gcda' -delete
# The numbers of their tests: the other programs are not built.
ctest --preset coverage --show-only=json-v1 | python3 -c '
import json, os, sys
tests = enumerate(json.load(sys.stdin)["tests"], 1)
ours = [i for i, t in tests if os.path.basename(t.get("command", [""])[0]) in sys.argv[1].split()]
print("0,0,0," + ",".join(map(str, ours)))' "$programs" > build/coverage/tests.list
ctest --preset coverage -j "$(nproc)" --timeout 3600 -LE slow -I build/coverage/tests.list
gcovr --root . --gcov-ignore-parse-errors --object-directory build/coverage --filter 'core/' --exclude-throw-branches \
  --html-details build/coverage/core.html --print-summary --fail-under-line 95 build/coverage
