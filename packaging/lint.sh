#!/usr/bin/env bash
# The layout and the lint of our C++: clang-format and clang-tidy, both as errors.
#   packaging/lint.sh               all of it (clang-tidy: about ten seconds a file and core)
#   packaging/lint.sh --since REV   the files that changed since a revision, and the sources of headers that did;
#                                   before a merge: --since "$(git merge-base main HEAD)"
#   packaging/lint.sh --format      the layout alone, in seconds (in ctest as "the layout of all sources")
set -euo pipefail
cd "$(dirname "$0")/.."

# Other versions lay out differently: that of Debian 12 decides, elsewhere the layout is not looked at.
FORMAT_VERSION=14

usage() { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }

# The files of ours, or those of them that changed, with their endings as arguments.
sources() {
  if [ -n "$since" ]; then
    git diff --name-only --diff-filter=d "$since" -- "$@"
  else
    git ls-files -- "$@"
  fi
}

check_format() {
  if ! git rev-parse --git-dir >/dev/null 2>&1; then
    echo "skipped: which files are ours is known to git alone"
    return 0
  fi
  if ! clang-format --version 2>/dev/null | grep -q "version $FORMAT_VERSION\."; then
    echo "skipped: clang-format $FORMAT_VERSION is not here"
    return 0
  fi
  sources '*.cpp' '*.h' | xargs -r clang-format --dry-run -Werror
}

# What clang-tidy reads. A header is looked at through the source of its name. Not among them: tests/ui, whose sources
# include what moc would make of them, and nothing is built here; tests/fuzz, half of which other presets compile;
# docs/examples, projects of their own; all in Python.
tidy_sources() {
  local folders=(core app ui python sample_volumes resources tests) header
  {
    sources "${folders[@]/%//*.cpp}"
    sources "${folders[@]/%//*.h}" | while read -r header; do git ls-files -- "${header%.h}.cpp"; done
  } | sort -u | sed -e '\#^tests/ui/#d' -e '\#^tests/fuzz/#d'  # grep -v fails where nothing is left
}

# A build folder of its own: clang does not read GCC's precompiled headers. Nothing is built in it.
check_tidy() {
  # shellcheck source=packaging/dependencies.sh
  . packaging/dependencies.sh
  install_dependencies build test lint
  configure lint >/dev/null
  tidy_sources |
    xargs -r -n 1 -P "$(nproc)" clang-tidy -p build/lint --quiet 2> >(grep -v ' warnings generated\.$' >&2)
}

since="" tidy=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --since) since="${2:-}"; [ -n "$since" ] || usage; shift ;;
    --format) tidy=no ;;
    *) usage ;;
  esac
  shift
done
check_format
if [ "$tidy" = yes ]; then check_tidy; fi
