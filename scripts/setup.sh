# shellcheck shell=bash disable=SC2034
# Sourced by scripts/run and scripts/test: the packages they need, and the folders they work in.
# Strict mode is the caller's. Everything said here goes to stderr.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
python=/usr/bin/python3                # Debian's own: it sees the python3-* packages, another one may not

run_packages=(cmake ninja-build g++ git libyaml-cpp-dev libcli11-dev libhdf5-dev libfmt-dev libspdlog-dev
              libnlopt-dev libnlopt-cxx-dev libgdal-dev python3-gdal
              python3 python3-numpy python3-matplotlib python3-h5py python3-yaml ffmpeg)
# The ray tracer of scripts/render, and the reader of meshes that stand in its pictures.
figure_packages=(povray python3-meshio)
test_packages=("${figure_packages[@]}" catch2 gdal-bin
               python3-scipy python3-xarray python3-h5netcdf python3-netcdf4 python3-jsonschema
               munge slurmctld slurmd slurm-client)
# Clang is there for the fuzz targets: the release whose C++20 goes with the system's standard library.
clang_debian=(clang-14 libclang-rt-14-dev libomp-14-dev)
clang_ubuntu=(clang-18 libclang-rt-18-dev libomp-18-dev)

say() { printf '%s\n' "$*" >&2; }
fail() { say "error: $*"; exit 1; }

# system_name: "debian 12", "ubuntu 24.04", ... as /etc/os-release has it.
system_name() {
  local file="${SANDSIM_OS_RELEASE:-/etc/os-release}"
  [ -r "$file" ] || { echo unknown; return; }
  # shellcheck disable=SC1090
  (. "$file"; echo "${ID:-unknown} ${VERSION_ID:-}")
}

is_installed() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# install_missing run|figures|test: installs what is not there yet; without anything missing it calls no apt.
install_missing() {
  local system wanted=("${run_packages[@]}") missing=() package
  system="$(system_name)"
  if [ "$1" = figures ]; then wanted+=("${figure_packages[@]}"); fi
  if [ "$1" = test ]; then
    wanted+=("${test_packages[@]}")
    case "$system" in
      "ubuntu 24.04") wanted+=("${clang_ubuntu[@]}") ;;
      *) wanted+=("${clang_debian[@]}") ;;
    esac
  fi
  if ! command -v dpkg-query >/dev/null; then
    fail "this system ($system) has no dpkg, so nothing can be installed here. Install what stands for these" \
         "Debian packages, then build with cmake --preset release: ${wanted[*]}"
  fi
  for package in "${wanted[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  case "$system" in
    "debian 12" | "ubuntu 24.04") ;;
    *) fail "packages are missing, and only Debian 12 and Ubuntu 24.04 are known here (this is $system)." \
            "Install these or what stands for them, then call again: ${missing[*]}" ;;
  esac
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "packages are missing and there is no sudo. As root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing with apt (${#missing[@]} packages): ${missing[*]}"
  "${as_root[@]}" apt-get update -q >&2 || fail "apt-get update failed"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" >&2 || fail "apt-get install failed"
}

# configure PRESET [-D...]: once; ninja itself configures again when a CMakeLists.txt changes.
configure() {
  local preset="$1" folder="$root/build/$1" fresh=()
  shift
  if ! command -v nvcc >/dev/null && [ -x /usr/local/cuda/bin/nvcc ]; then
    export PATH="$PATH:/usr/local/cuda/bin"
  fi
  if [ -f "$folder/CMakeCache.txt" ]; then
    # A build folder that came along with a moved or copied checkout would build the old sources.
    if grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
      [ -f "$folder/build.ninja" ] && return 0
    else
      fresh=(--fresh)
    fi
  fi
  say "Configuring build/$preset"
  (cd "$root" && cmake --preset "$preset" "${fresh[@]}" "$@") >&2
}
