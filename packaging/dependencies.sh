# Sourced by the scripts beside it: installs the Debian packages that are missing (Debian 12 and 13).
# shellcheck shell=bash

BUILD_PACKAGES="g++ cmake ninja-build ccache libvtk9-dev libinsighttoolkit5-dev libdcmtk-dev libeigen3-dev libcli11-dev nlohmann-json3-dev libssl-dev zlib1g-dev libzip-dev libexpat1-dev qt6-base-dev qt6-svg-dev qt6-l10n-tools libqt6svg6 pybind11-dev python3-dev"
TEST_PACKAGES="catch2 clang-format doxygen libcgal-dev xvfb fonts-dejavu-core fonts-droid-fallback qt6-translations-l10n python3-numpy python3-pytest python3-matplotlib python3-pydicom dcmtk dicom3tools assimp-utils gmsh tetgen slurmctld slurmd slurm-client"
PACKAGE_PACKAGES="file dpkg-dev fakeroot"
COVERAGE_PACKAGES="gcovr"
LINT_PACKAGES="clang-tidy"
RUN_PACKAGES="qt6-qpa-plugins qt6-wayland qt6-translations-l10n fonts-dejavu-core fonts-droid-fallback libgl1-mesa-dri"

# The packages of the groups named ("build", "test", "package", "coverage", "lint", "run"), on this release of Debian.
wanted_packages() {
  local group
  for group in "$@"; do
    case "$group" in
      build) echo "$BUILD_PACKAGES" ;;
      test) echo "$TEST_PACKAGES" ;;
      package) echo "$PACKAGE_PACKAGES" ;;
      coverage) echo "$COVERAGE_PACKAGES" ;;
      lint) echo "$LINT_PACKAGES" ;;
      run) echo "$RUN_PACKAGES" ;;
      *) echo "unknown group of packages: $group" >&2; return 1 ;;
    esac
  done
  # Debian 13's ITK does not link without FFTW; Debian 12 has Qt's OpenGL classes in a package of their own.
  # shellcheck source=/dev/null
  (. /etc/os-release; if [ "${VERSION_ID:-13}" = 12 ]; then echo libqt6opengl6-dev; else echo libfftw3-dev; fi)
}

is_installed() {
  dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'
}

# Runs a command as root; DEBIAN_FRONTEND goes through `env` because sudo drops the environment.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

can_be_root() { [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null; }

# install_dependencies GROUP…; needs the network only if something is missing.
install_dependencies() {
  local wanted package missing=""
  wanted=$(wanted_packages "$@")
  for package in $wanted; do
    is_installed "$package" || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  if ! command -v apt-get >/dev/null || ! can_be_root; then
    echo "These packages are missing, and this user cannot install them here (apt-get, and root or sudo):$missing" >&2
    return 1
  fi
  echo "Installing:$missing"
  as_root apt-get update -q </dev/null
  # shellcheck disable=SC2086
  as_root apt-get install -y -q --no-install-recommends $missing </dev/null
}

# configure PRESET [OPTION…]: a build folder that cannot be used any more (the sources were moved) is set up anew.
configure() {
  cmake --preset "$@" && return 0
  grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "build/$1/CMakeCache.txt" && return 1  # not for that reason
  echo "Configuring failed; once more in an empty build folder."
  cmake --fresh --preset "$@"
}
