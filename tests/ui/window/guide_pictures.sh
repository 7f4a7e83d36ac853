#!/bin/sh
# Makes the pictures of the guide anew, of the program as it is; look at them before they are committed:
#   HANDLEBODY_SCREEN=2560x1600x24 QT_SCALE_FACTOR=2 sh tests/ui/with_display.sh
#     sh tests/ui/window/guide_pictures.sh PROGRAM sample_volumes resources/guide
# They are drawn twice as fine and reduced to the pixels that a fine screen shows them with. Needs ImageMagick.
program=$1
session=$2/cyst_session.json
out=$3

# shot NAME OPTION …
shot() {
  name=$1
  shift
  "$program" "$session" --screenshot "$out/$name.png" --size 1280x800 --appearance light "$@" || exit 1
  convert "$out/$name.png" -resize 1440x900 -colors 220 -strip "png8:$out/$name.png" || exit 1
}

shot window --step grow --iteration 1000
shot seed --step seed
shot tune --step tune
shot grow --step grow --iteration 28
shot event --step grow --iteration 36 --stage handle
