# Sourced by scripts/bench, scripts/test and .ci/run: installs what is missing on Debian 12, configures and
# builds. Elsewhere, or without root, it says what to install.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Embree 4 where the distribution has it, else 3.
packages=(g++ cmake ninja-build libtbb-dev libcli11-dev nlohmann-json3-dev libtinyobjloader-dev
          librandom123-dev libxxhash-dev libgtest-dev libopenimageio-dev openimageio-tools)

# install_packages NAME...: apt-get, only for what is not there.
install_packages() {
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'install ok installed' || missing+=("$name")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "needed, but there is no apt-get to install them: ${missing[*]}" >&2
    return 1
  fi
  local as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  echo "installing: ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

install_prerequisites() {
  command -v dpkg-query >/dev/null || { echo "not Debian: install the packages of $root/scripts/setup.sh by other means" >&2; return 0; }
  if dpkg-query -W -f='${Status}' libembree-dev 2>/dev/null | grep -q 'install ok installed' ||
     ! apt-cache show libembree4-dev >/dev/null 2>&1; then
    packages+=(libembree-dev)
  else
    packages+=(libembree4-dev)
  fi
  install_packages "${packages[@]}"
}

# build PRESET [TARGET...]
build() {
  local preset=$1
  shift
  (cd "$root" && cmake --preset "$preset" >"$root/build-$preset.log" 2>&1) ||
    { cat "$root/build-$preset.log" >&2; return 1; }
  rm -f "$root/build-$preset.log"
  cmake --build "$root/build/$preset" ${1:+--target "$@"} >&2
}
