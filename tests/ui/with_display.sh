#!/bin/sh
# Runs a program on an X server of its own with OpenGL in software: with_display.sh PROGRAM [ARGUMENT …]
# Where there is no Xvfb it says so and succeeds; tests are told apart by the word SKIPPED.
if ! command -v Xvfb > /dev/null; then
  echo "SKIPPED: no Xvfb on this machine"
  exit 0
fi
folder=$(mktemp -d) || exit 1
server=
trap 'test -n "$server" && kill "$server" 2> /dev/null; rm -rf "$folder"' EXIT
trap 'exit 1' INT TERM
mkfifo "$folder/display"
Xvfb -displayfd 3 -noreset -screen 0 "${HANDLEBODY_SCREEN:-1680x1050x24}" -nolisten tcp 3> "$folder/display" 2> "$folder/log" &
server=$!
# The server writes its number when it is ready, and closes the pipe when it fails.
read -r number < "$folder/display"
if [ -z "$number" ]; then
  cat "$folder/log" >&2
  exit 1
fi
mkdir -m 700 "$folder/home" "$folder/runtime"
env DISPLAY=":$number" QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QT_STYLE_OVERRIDE=Fusion \
  QT_SCALE_FACTOR="${QT_SCALE_FACTOR:-1}" LC_ALL=C.UTF-8 HOME="$folder/home" XDG_RUNTIME_DIR="$folder/runtime" "$@"
