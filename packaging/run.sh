#!/usr/bin/env bash
# From a fresh Debian (git, apt, root or sudo) to the main job: installs what is missing, builds the programs, and
# opens the window on the ultrasound sample, a dark cyst with a bright needle through it, with its seed placed.
# Without a display handlebody-cli does the same work.
#   packaging/run.sh [OUTPUT_FOLDER]        default: ./handlebody-output; for the files that are made without a display
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
output=${1:-handlebody-output}
mkdir -p "$output"
output=$(cd "$output" && pwd)

cd "$root"
# shellcheck source=packaging/dependencies.sh
. packaging/dependencies.sh
install_dependencies build run
# In a build folder of its own: without tests, so that their packages need not be there.
configure release -B build/run -DBUILD_TESTING=OFF
cmake --build build/run -j "$(nproc)" --target handlebody-cli handlebody

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  echo "Opening the window on the ultrasound sample: press Space to grow the surface, F1 for the guide."
  exec build/run/app/handlebody sample_volumes/cyst_session.json
fi

cli=build/run/app/handlebody-cli
echo
echo "Segmenting sample_volumes/cyst.nii.gz (ultrasound, 100 x 50 x 86 voxels of 2 mm) ..."
"$cli" segment sample_volumes/cyst.nii.gz --seed 77,49,85,8 --object dark \
  -o "$output/cyst.stl" --report "$output/cyst.json" --picture "$output/cyst.png"
echo
echo "The mesh, read back from its file (genus 1: the needle goes through the cyst like a hole through a ring):"
"$cli" check "$output/cyst.stl"
echo
echo "Mesh:     $output/cyst.stl"
echo "Report:   $output/cyst.json"
echo "Picture:  $output/cyst.png"
