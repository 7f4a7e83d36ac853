#!/usr/bin/env bash
# Installs a package in a fresh Debian (debootstrap, as root) and starts both programs there. Where the packages of the Python
# module and of the library lie beside it, these are installed, too, and the examples of docs/examples run:
#   packaging/try_deb.sh PACKAGE.deb [RELEASE]     default: the release of this machine
# Leaves a picture of the window beside the package.
set -euo pipefail
package=$(readlink -f "$1")
# shellcheck source=/dev/null
machine=$(. /etc/os-release && echo "$VERSION_CODENAME")
release=${2:-$machine}
mirror=${HANDLEBODY_MIRROR:-http://deb.debian.org/debian}
here=$(cd "$(dirname "$0")" && pwd)
if [ "$(id -u)" -ne 0 ]; then
  echo "try_deb.sh needs root: it makes a Debian of its own with debootstrap." >&2
  exit 2
fi
folder=$(mktemp -d)
trap 'rm -rf --one-file-system "$folder"' EXIT
debootstrap --variant=minbase "$release" "$folder/debian" "$mirror"
# The machine's own sources and proxy, so that a local mirror serves here, too; those of the other release if it is another.
cp -rT /etc/apt "$folder/debian/etc/apt"
find "$folder/debian/etc/apt" -name '*.list' -o -name '*.sources' | xargs -r sed -i "s/\<$machine\>/$release/g"
cp "$package" "$folder/debian/handlebody.deb"
for name in python3-handlebody libhandlebody-dev; do
  for beside in "$(dirname "$package")/${name}"_*.deb; do
    if [ -e "$beside" ]; then cp "$beside" "$folder/debian/$name.deb"; fi
  done
done
cp -r "$here/../docs/examples" "$folder/debian/examples"
cp "$here/../tests/ui/with_display.sh" "$folder/debian/with_display.sh"
cp /etc/resolv.conf "$folder/debian/etc/resolv.conf" || true

# In mounts of its own: /proc and /dev go with it.
export folder
unshare --mount bash -euc '
  mount -t proc proc "$folder/debian/proc"
  mount --rbind /dev "$folder/debian/dev"
  run() { chroot "$folder/debian" env DEBIAN_FRONTEND=noninteractive "$@"; }
  run apt-get update -q
  run apt-get install -y -q --no-install-recommends /handlebody.deb
  sample=/usr/share/handlebody/sample_volumes
  run handlebody --version
  run handlebody-cli segment "$sample/cyst.nii.gz" --seed 77,49,85,8 --object dark -o /tmp/cyst.stl --quiet
  run handlebody-cli check /tmp/cyst.stl
  if [ -e "$folder/debian/python3-handlebody.deb" ]; then
    run apt-get install -y -q --no-install-recommends /python3-handlebody.deb python3-matplotlib
    run python3 /examples/python/sweep.py
    run python3 /examples/python/leak_study.py
    run sh -c "cd /tmp && python3 /examples/python/plot.py && test -s torus.png"
  fi
  if [ -e "$folder/debian/libhandlebody-dev.deb" ]; then
    run apt-get install -y -q --no-install-recommends /libhandlebody-dev.deb g++ cmake make
    run sh -c "cmake -S /examples/grow -B /tmp/grow && cmake --build /tmp/grow && /tmp/grow/grow"
  fi
  run apt-get install -y -q --no-install-recommends xvfb libgl1-mesa-dri
  run sh /with_display.sh handlebody "$sample/cyst_session.json" --screenshot /tmp/window.png --iteration 20
  run test -s /tmp/window.png
'
cp "$folder/debian/tmp/window.png" "${package%.deb}.png"  # to be looked at
echo "The package installs and both programs work in a fresh $release."
