# Sourced by scripts/bench, scripts/test and .ci/run: installs what is missing on Debian 12, configures and
# builds. Elsewhere it says what to install.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# libboost-dev: Boost.Math. openimageio-tools: the library's CMake
# package checks that its tools are there. python3 and curl: scripts/fetch_scenes. python3-matplotlib:
# scripts/plot and scripts/report, which takes differences of pictures with python3-openimageio.
# python3-jsonschema: tests of configs/schema.
packages=(g++ cmake ninja-build libtbb-dev libcli11-dev nlohmann-json3-dev libtinyobjloader-dev
          librandom123-dev libxxhash-dev libgtest-dev libboost-dev libopenimageio-dev openimageio-tools
          python3 curl python3-matplotlib python3-openimageio python3-jsonschema)

is_installed() {
  dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# install_packages NAME...: only what is not there. A name may list alternatives, as in a|b; the first that
# the distribution has is taken.
install_packages() {
  if ! command -v apt-get >/dev/null; then
    echo "no apt-get here; these packages, or their like, must be there already: $*" >&2
    return 0
  fi
  local missing=() name alternative
  for name in "$@"; do
    for alternative in ${name//|/ }; do
      ! is_installed "$alternative" || continue 2
    done
    missing+=("$name")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  as_root apt-get update -qq
  local chosen=()
  for name in "${missing[@]}"; do
    for alternative in ${name//|/ }; do
      if apt-cache show "$alternative" >/dev/null 2>&1; then
        chosen+=("$alternative")
        break
      fi
    done
  done
  echo "installing: ${chosen[*]}" >&2
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${chosen[@]}" >/dev/null
}

install_prerequisites() {
  install_packages "${packages[@]}" 'libembree4-dev|libembree-dev'
}

# For the presets asan, tsan and fuzz: the compiler, its sanitizers, and what names the lines in their reports.
install_clang() {
  install_packages clang libclang-rt-dev llvm
}

# build PRESET [TARGET...]
build() {
  local preset=$1 log
  shift
  log=$(mktemp)
  (cd "$root" && cmake --preset "$preset" >"$log" 2>&1) || { cat "$log" >&2; rm -f "$log"; return 1; }
  rm -f "$log"
  cmake --build "$root/build/$preset" ${1:+--target "$@"} >&2
}
