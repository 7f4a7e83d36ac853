#!/bin/sh
# The program from outside: program_test.sh PROGRAM WITH_DISPLAY SAMPLES
program=$1
display=$2
samples=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failed=0

fail() {
  echo "FAILED: $1" >&2
  failed=1
}

"$program" --version | grep -q '^handlebody [0-9]' || fail "--version"
"$program" --help | grep -q 'not a medical device' || fail "--help carries the notice"

"$program" --view nonsense 2> "$folder/error"
test $? -eq 2 || fail "a wrong option ends with 2"

"$program" --size 800x600 2> "$folder/error"
test $? -eq 2 && grep -q -e '--screenshot' "$folder/error" || fail "--size without --screenshot ends with 2"

cp "$samples/cyst.nii.gz" "$samples/cyst_session.json" "$folder"
cp "$folder/cyst.nii.gz" "$folder/before.nii.gz"
for picture in cyst_session.json cyst.nii.gz other.tiff --view; do
  "$program" "$folder/cyst_session.json" --screenshot "$folder/$picture" 2> "$folder/error"
  test $? -eq 2 && grep -q -e '--screenshot' "$folder/error" || fail "a picture is not written to $picture"
done
cp "$folder/cyst.nii.gz" "$folder/cyst.png"
"$program" "$folder/cyst.png" --screenshot "$folder/cyst.png" 2> "$folder/error"
test $? -eq 2 && grep -q 'it is the input' "$folder/error" || fail "a picture is not written over the input"
cmp -s "$folder/cyst.nii.gz" "$folder/before.nii.gz" || fail "the volume is as it was"

env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$program" 2> "$folder/error"
test $? -eq 1 || fail "without a display it ends with 1"
grep -q 'no display' "$folder/error" || fail "without a display it says so"

if ! command -v Xvfb > /dev/null; then
  echo "SKIPPED: no Xvfb on this machine"
  exit $failed
fi

# Prints width and height of a PNG.
size_of() {
  od -A n -t u1 -j 16 -N 8 "$1" | awk '{ print $1*16777216+$2*65536+$3*256+$4 "x" $5*16777216+$6*65536+$7*256+$8 }'
}

sh "$display" "$program" "$samples/cyst_session.json" --screenshot "$folder/window.png" --iteration 3 --size 1280x800 ||
  fail "--screenshot of the window"
test "$(size_of "$folder/window.png")" = 1280x800 || fail "the picture has the size that was asked for"

for view in all axial coronal sagittal 3d; do
  sh "$display" "$program" "$samples/cyst.nii.gz" --screenshot "$folder/$view.png" --view $view && test -s "$folder/$view.png" ||
    fail "--view $view"
done

# Without --screenshot it stays open with its volume until it is ended (124: by timeout).
sh "$display" timeout 8 "$program" "$samples/cyst.nii.gz" 2> "$folder/error"
test $? -eq 124 || fail "the window stays open with its volume"

sh "$display" "$program" "$samples/cyst_session.json" --screenshot "$folder/none.png" --iteration 1 --stage open 2> "$folder/error"
test $? -eq 2 && grep -q 'no event at iteration 1' "$folder/error" || fail "a stage without an event ends with 2"
test ! -e "$folder/none.png" || fail "no picture of a stage without an event"

echo "not a volume" > "$folder/bad.nii"
sh "$display" "$program" "$folder/bad.nii" --screenshot "$folder/bad.png" 2> "$folder/error"
test $? -eq 3 || fail "a bad file ends with 3"
grep -q 'bad.nii' "$folder/error" || fail "the message names the file"
test ! -e "$folder/bad.png" || fail "no picture of a bad file"
exit $failed
