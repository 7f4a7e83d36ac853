# Sourced by run.sh and test.sh: installs the Debian packages that are missing (Debian 12 and 13).

BUILD_PACKAGES="g++ cmake ninja-build ccache libvtk9-dev libinsighttoolkit5-dev libeigen3-dev libcli11-dev nlohmann-json3-dev libssl-dev zlib1g-dev"
TEST_PACKAGES="catch2 libcgal-dev"

install_dependencies() {
  local wanted="" missing="" p
  for group in "$@"; do
    case "$group" in
      build) wanted="$wanted $BUILD_PACKAGES" ;;
      test) wanted="$wanted $TEST_PACKAGES" ;;
    esac
  done
  # Debian 13's ITK needs FFTW's headers beside it; harmless on 12.
  wanted="$wanted libfftw3-dev"
  for p in $wanted; do
    dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $p"
  done
  [ -z "$missing" ] && return 0
  local sudo=""
  [ "$(id -u)" -eq 0 ] || sudo=sudo
  echo "Installing:$missing"
  $sudo apt-get update -q
  # shellcheck disable=SC2086
  DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y -q --no-install-recommends $missing
}
