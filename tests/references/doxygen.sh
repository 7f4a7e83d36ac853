#!/usr/bin/env bash
# Doxygen finds no fault in the comments of the engine's headers: doxygen.sh DOXYFILE FOLDER. Where it is not installed the
# test is skipped.
set -euo pipefail
if ! command -v doxygen >/dev/null; then exit 77; fi
mkdir -p "$2"
{ cat "$1"; printf 'OUTPUT_DIRECTORY = "%s"\n' "$2"; } | doxygen -
