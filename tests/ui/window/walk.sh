#!/bin/sh
# Walks through the real program with mouse and keys as a new user would, and takes a picture of the screen at
# every station, to be looked at by a person:
#   HANDLEBODY_SCREEN=1280x800x24 sh tests/ui/with_display.sh sh tests/ui/window/walk.sh PROGRAM SAMPLES OUT [light|dark [FOLDER …]]
# The screen is as large as the window. With QT_SCALE_FACTOR=2 it must be twice as large. Each FOLDER (or file)
# is opened as well, and pictures taken of what the window says and of a growth in its middle. Needs openbox,
# xdotool and ImageMagick.
program=$1
samples=$2
out=$3
appearance=${4:-light}
if [ $# -gt 4 ]; then shift 4; else shift $#; fi
for tool in openbox xdotool import; do
  command -v $tool > /dev/null || { echo "walk.sh needs $tool" >&2; exit 1; }
done
scale=${QT_SCALE_FACTOR:-1}
mkdir -p "$out" || exit 1
station=10
running=
manager=
trap 'test -n "$running" && kill "$running" 2> /dev/null; test -n "$manager" && kill "$manager" 2> /dev/null' EXIT
trap 'exit 1' INT TERM

settle() { sleep "${1:-0.6}"; }

# picture NAME: of the whole screen.
picture() {
  settle
  import -window root "$out/$station-$1.png"
  station=$((station + 1))
}

key() { xdotool key --delay 60 "$@"; settle 0.25; }

# click X Y: in logical pixels of the screen.
click() { xdotool mousemove $(($1 * scale)) $(($2 * scale)) click 1; settle 0.3; }

# start [FILE]: opens the program and waits until its window fills the screen.
start() {
  "$program" "$@" &
  running=$!
  window=
  for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --name 'Handlebody$' 2> /dev/null | head -n 1)
    test -n "$window" && break
    sleep 0.1
  done
  test -n "$window" || { echo "no window of $program" >&2; exit 1; }
  xdotool windowmove "$window" 0 0 windowsize "$window" $(xdotool getdisplaygeometry)
  xdotool mousemove 0 0
  settle 2
}

# finish SIGNAL
finish() {
  kill -s "$1" "$running"
  wait "$running" 2> /dev/null
  running=
}

# menu LETTER NAME [KEY …]: opens a menu, goes on in it by keys, takes a picture, closes it.
menu() {
  letter=$1 name=$2
  shift 2
  key "alt+$letter"
  test $# -gt 0 && key "$@"
  picture "menu-$name"
  key Escape Escape Escape
}

# choose PATH: in the dialog that Ctrl+O opens.
choose() {
  key ctrl+o
  settle 1
  xdotool type --delay 5 "$1"
  settle 0.3
  test -n "$2" && picture "$2"
  key Return
  settle 1.5
}

settings=$HOME/.config/Handlebody
mkdir -p "$settings" "$HOME/.config/openbox"
number=1
test "$appearance" = dark && number=2
printf '[General]\nappearance=%s\n' $number > "$settings/handlebody.conf"
cat > "$HOME/.config/openbox/rc.xml" << RC
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <placement><policy>Smart</policy><center>yes</center></placement>
  <applications><application type="normal"><decor>no</decor></application></applications>
</openbox_config>
RC
openbox --config-file "$HOME/.config/openbox/rc.xml" 2> /dev/null &
manager=$!
settle 1

# 1 Nothing is open.
start
picture notice
key Return
picture start
for step in 2 3 4 5; do
  key alt+$step
  picture "empty-step-$step"
done
key alt+1
key F1
picture guide
key Next Next
picture guide-below
key End
picture guide-end
key Escape
key shift+F1
picture keys
key Next Next
picture keys-below
key Escape
menu h about-entry
key alt+h a
picture about
key Escape
choose "$samples/cyst.nii.gz" open-dialog
picture opened

# 2 A seed, the parameters, the growth.
key Escape
key ctrl+0
read -r width height << SIZE
$(xdotool getdisplaygeometry | awk -v s="$scale" '{ print int($1 / s), int($2 / s) }')
SIZE
# In the axial view, the upper left of the four.
click $((300 + (width - 300) / 4 - 20)) $((72 + (height - 300) / 4))
key Return
settle 2
picture seed
menu f file
menu f recent r
menu e edit
menu v view
for letter in l s p c e o f a; do menu v "view-$letter" $letter; done
menu s seed
menu g grow
key alt+3
settle 1
picture tune
key alt+1
picture open-facts
# It is at its end within seconds.
key alt+4
xdotool key space
sleep 0.3
import -window root "$out/$station-running.png"
xdotool key space
station=$((station + 1))
picture paused
key ctrl+Home
key n
settle 4
picture event
across=100
for stage in collide open handle close; do  # the buttons in the panel
  click $across 558
  settle 2
  picture "stage-$stage"
  across=$((across + 60))
done
key space
settle 8
picture end
key alt+5
picture export
key ctrl+e
settle 1
picture export-dialog
key Escape
key w
key ctrl+4
picture only-3d
key ctrl+1
picture only-axial
key ctrl+0
key w

# 3 What goes wrong.
echo "no volume" > "$out/a file that is no volume.nii.gz"
choose "$out/a file that is no volume.nii.gz"
picture unsaved
key Tab Return
settle 1
picture error
rm "$out/a file that is no volume.nii.gz"
finish KILL

start
picture recovery
menu f recent-start r
finish TERM
for path in "$@"; do
  start "$path"
  settle 4
  picture "opened-$(basename "$path")"
  key alt+1
  picture "facts-$(basename "$path")"
  key Escape
  click $((300 + (width - 300) / 4 - 20)) $((72 + (height - 300) / 4))
  key Return
  settle 1
  xdotool key space
  settle 2
  picture "running-$(basename "$path")"
  finish KILL
done
