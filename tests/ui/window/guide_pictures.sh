#!/bin/sh
# Makes the pictures of the guide anew, of the program as it is; look at them before they are committed:
#   HANDLEBODY_SCREEN=2560x1600x24 QT_SCALE_FACTOR=2 sh tests/ui/with_display.sh
#     sh tests/ui/window/guide_pictures.sh PROGRAM sample_volumes resources/guide
# handlebody-cli must lie beside PROGRAM. They are drawn twice as fine and reduced to the pixels that a fine screen shows them with. Needs ImageMagick.
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

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# Rulers and the table of measures: the session with what is measured in it.
python3 - "$session" "$work/measured.json" << 'END' || exit 1
import json, os, sys
session = json.load(open(sys.argv[1]))
session["input"]["path"] = os.path.join(os.path.dirname(os.path.abspath(sys.argv[1])), session["input"]["path"])
session["measurements"] = [
    {"kind": "ruler", "points": [[45, 49, 85], [150, 49, 85]]},
    {"kind": "angle", "points": [[77, 30, 95], [77, 48, 70], [77, 68, 92]]},
]
json.dump(session, open(sys.argv[2], "w"))
END
session=$work/measured.json
shot measures --step measure --iteration 1000

# A beating heart, carried through its frames.
"$(dirname "$program")/handlebody-cli" phantom beating --frames 20 -o "$work/heart.nii.gz" > "$work/heart.json" || exit 1
python3 - "$work" << 'END' || exit 1
import json, sys
seed = json.load(open(sys.argv[1] + "/heart.json"))["seed"]["centre"]
json.dump({"version": "0.1.0", "input": {"path": "heart.nii.gz", "sha256": None}, "requested": {"seeds": [{"centre": seed}]}},
          open(sys.argv[1] + "/heart_session.json", "w"))
END
session=$work/heart_session.json
shot time --step time --iteration 1000
session=$work/measured.json

# A leak through a hole in a wall: leaked, painted shut, and gone on from before.
"$(dirname "$program")/handlebody-cli" phantom wall --gap 14 --noise 0.1 -o "$work/wall.nii.gz" > /dev/null || exit 1
walls=
for y in 36 40 44; do
  for z in 32 34 36 38 40 42 44 46 48; do walls="$walls{\"centre\": [50, $y, $z], \"radius\": 4},"; done
done

# leak NAME ITERATION_OF_THE_WALLS ITERATION OPTION …
leak() {
  name=$1 since=$2 iteration=$3
  shift 3
  changes="\"changes\": [{\"iteration\": $since, \"range\": [0, 120], \"constraints\": {\"walls\": [${walls%,}]}}], \"stop_at\": $since,"
  test "$since" = none && changes=
  echo "{\"version\": \"0.1.0\", \"input\": {\"path\": \"wall.nii.gz\", \"sha256\": null}, \"requested\": {\"range\": [0, 120],
    $changes \"seeds\": [{\"centre\": [28.5, 39.5, 39.5], \"radius\": 10}]}}" > "$work/session.json"
  "$program" "$work/session.json" --screenshot "$work/$name.png" --size 1280x800 --appearance light --iteration "$iteration" "$@" || exit 1
}

leak leaked none 119 --view axial
leak painted 119 119 --view axial
leak mended 12 1000 --view axial
convert "$work/leaked.png" "$work/painted.png" "$work/mended.png" -bordercolor white -border 6x0 +append -resize 1440x -colors 220 -strip \
  "png8:$out/mend_steps.png" || exit 1
leak window 12 1000 --step correct
convert "$work/window.png" -resize 1440x900 -colors 220 -strip "png8:$out/mend.png" || exit 1
