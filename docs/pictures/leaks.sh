#!/bin/sh
# Makes the pictures of docs/leaks.md anew, of the program as it is: four real leaks before and after they are
# mended; look at them before they are committed:
#   sh tests/ui/with_display.sh sh docs/pictures/leaks.sh PROGRAM VOLUMES docs/pictures [NAME …]
# VOLUMES is the folder of cases.json; handlebody-cli must lie beside PROGRAM. NAME: only these. Needs
# ImageMagick, and some minutes.
program=$1
volumes=$2
out=$3
shift 3
only=$*
cli=$(dirname "$program")/handlebody-cli
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

# shot NAME VOLUME ITERATION CROSSHAIR OPTION …: the four views at that iteration, or where it ends.
shot() {
  file=$1 data=$2 until=$3 crosshair=$4
  shift 4
  session=$work/$file.json
  # The seed is written in mm there; nothing is grown yet.
  "$cli" segment "$volumes/$data" "$@" --max-iterations 1 --session "$session" -o "$work/seed.ply" 2> /dev/null
  test $? = 5 || exit 1
  sed -i "s|\"max_iterations\": 1,|\"max_iterations\": $until,|; 1s|{|{\"view\": {\"crosshair\": [$crosshair], \"slicesIn3d\": false},|" "$session"
  "$program" "$session" --screenshot "$work/$file.png" --size 1100x820 --view all --iteration "$until" || exit 1
}

# pair NAME VOLUME ITERATION CROSSHAIR "OPTION …" WALL …: leaked at that iteration, and mended at its end.
pair() {
  name=$1 volume=$2 iteration=$3 crosshair=$4 options=$5
  shift 5
  case " ${only:-$name} " in *" $name "*) ;; *) return ;; esac
  # shellcheck disable=SC2086
  shot before "$volume" "$iteration" "$crosshair" $options
  # shellcheck disable=SC2086
  shot after "$volume" 5000 "$crosshair" $options "$@"
  convert "$work/before.png" "$work/after.png" -bordercolor white -border 6x0 +append -resize 1100x -colors 100 -strip \
    "png8:$out/leak_$name.png" || exit 1
}

pair us_vessel us_liver_invivo/liver_us_1mm.mha 100 -4.7,-3.1,119 \
  "--seed-ijk 148,101,84,3 --object dark --range=-inf,34.17" --wall=11.3,-19.6,126.7,15 --wall=0.5,-5.3,146,18 \
  --wall=-25.5,-5.5,140.1,18 --wall=16.8,-12.3,109.8,10 --wall=-27.3,12,100.7,22
pair ventricle mr_t1_head/MR.nii.gz 120 312,-39,455.5 \
  "--seed-ijk 76,140,75,2 --object dark --range=-inf,189.56" --wall=312,-39,455.5,6
pair trachea ct_thorax_cta/ct_thorax_1p5mm.nii.gz 235 61,-146.2,703.1 \
  "--seed-ijk 44,65,140,3 --object dark --range=-inf,-760" --wall=61,-146.2,703.1,8 --wall=-45.5,-156,725.3,6 \
  --wall=-46,-141,726.4,8
pair aorta ct_thorax_cta/ct_thorax_1p5mm.nii.gz 180 -17.7,-168.7,708.2 \
  "--seed-ijk 61,72,140,3 --object bright --range=355.06,inf" --wall=21.3,-183.7,654.2,12 \
  --wall=-17.7,-168.7,708.2,12 --wall=-11.7,-174.7,747.2,6
