#!/usr/bin/env bash
# Set-up and build, shared by lessons/run and tests/run.
#   bash lessons/setup.sh [clang|bench|peers|docs|pages|book|playground|web]   installs what is missing, and builds nothing
# When sourced it only defines: cairn_set_up [the same], cairn_build PRESET TARGET..., cairn_watch.

unset CDPATH
cairn_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cairn_installed=no  # becomes yes when packages were installed: then CMake has to look again

cairn_packages=(g++ make cmake ninja-build pkg-config ccache libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libstb-dev zlib1g-dev fonts-dejavu-core libosmesa6-dev libegl-dev libbox2d-dev doctest-dev
  libtomlplusplus-dev)
cairn_bench_packages=(libbenchmark-dev ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd)
cairn_peer_packages=(libbenchmark-dev libchipmunk-dev libbullet-dev)
# What makes the pages of the lesson book.
cairn_pages_packages=(pandoc)
# What tests look at beside the code: its documentation, the book, and a device for OpenCL, which is the processor.
cairn_docs_packages=(doxygen "${cairn_pages_packages[@]}" ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd)
cairn_clang_packages=(clang clang-tidy clang-format libclang-rt-dev)
# A browser for the test of the lesson book. Node.js comes in packages of other makers too, npm within it.
cairn_book_packages=(chromium)
if ! command -v npm >/dev/null; then cairn_book_packages+=(nodejs npm); fi
# What compiles the core for browsers, bundles the page and cuts its fonts.
cairn_playground_packages=(emscripten esbuild fonttools)
if ! command -v node >/dev/null; then cairn_playground_packages+=(nodejs); fi
# Packages that some releases do not have. Without OSMesa the pictures are drawn through EGL; engines to compare with may
# be missing.
cairn_dispensable=" ocl-icd-opencl-dev opencl-clhpp-headers pocl-opencl-icd libosmesa6-dev libclang-rt-dev libchipmunk-dev libbullet-dev "

# cairn_watch WHAT LOG PATTERN [ALL]: keeps the lines of stdin in LOG and says on stderr how far WHAT has come. A line
# that matches PATTERN is one of ALL; or it tells, by two groups of the pattern, how many are done of how many. On a
# terminal one line is rewritten; elsewhere there is a line every five seconds, also while nothing comes.
cairn_watch() {
  local what=$1 log=$2 pattern=$3 all=${4:-} line='' part='' done=0 begun=$SECONDS said=$SECONDS code
  : >"$log"
  while true; do
    IFS= read -r -t 1 part
    code=$?
    line+=$part
    if [[ $code == 0 ]]; then
      printf '%s\n' "$line" >>"$log"
      if [[ $line =~ $pattern ]]; then
        done=$((done + 1))
        if [[ ${BASH_REMATCH[2]:-} ]]; then done=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}; fi
      fi
      line=''
    elif [[ $code -le 128 ]]; then
      break
    fi
    if [[ -t 2 ]]; then
      printf '\r\033[K%s: %s%s, %s s ' "$what" "$done" "${all:+ of $all}" $((SECONDS - begun)) >&2
    elif [[ $((SECONDS - said)) -ge 5 ]]; then
      printf '%s: %s%s, %s s\n' "$what" "$done" "${all:+ of $all}" $((SECONDS - begun)) >&2
      said=$SECONDS
    fi
  done
  if [[ -t 2 ]]; then printf '\r\033[K' >&2; fi
}

# Prints those of the given packages that are not installed.
cairn_missing() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p')
  local package
  for package in "$@"; do
    [[ $'\n'$installed$'\n' == *$'\n'$package$'\n'* ]] || printf '%s\n' "$package"
  done
}

# Prints the given packages without those that apt has no candidate for and Cairn can do without.
cairn_available() {
  local package
  for package in "$@"; do
    if [[ $cairn_dispensable == *" $package "* ]] && ! apt-cache show "$package" >/dev/null 2>&1; then continue; fi
    printf '%s\n' "$package"
  done
}

cairn_install() {
  local -a as_root=()
  if [[ $(id -u) != 0 ]]; then
    # A password may be asked for only where somebody can type it.
    if command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
      as_root=(sudo)
    else
      printf 'These packages are missing, and installing them needs an administrator:\n  %s\n' "$*" >&2
      printf 'Ask one to run:\n  apt-get update && apt-get install --no-install-recommends %s\n' "$*" >&2
      return 2
    fi
  fi
  printf 'Installing %s\n' "$*" >&2
  local log steps
  log=$(mktemp)
  "${as_root[@]}" apt-get update -q 2>&1 | cairn_watch 'Lists of packages' "$log" '^(Get|Hit):'
  [[ ${PIPESTATUS[0]} == 0 ]] || printf 'apt-get update failed; going on with what apt knows.\n' >&2
  local -a wanted
  mapfile -t wanted < <(cairn_available "$@")
  # Each package is fetched, unpacked and set up.
  steps=$((3 * $(apt-get install -s --no-install-recommends "${wanted[@]}" 2>/dev/null | grep -c '^Inst ')))
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${wanted[@]}" 2>&1 |
    cairn_watch 'Steps of installing' "$log" '^(Get:|Unpacking |Setting up )' "$steps"
  if [[ ${PIPESTATUS[0]} != 0 ]]; then
    tail -n 20 "$log" >&2
    printf 'The installation failed. What is missing:\n  %s\n' "${wanted[*]}" >&2
    rm -f "$log"
    return 2
  fi
  rm -f "$log"
  cairn_installed=yes
}

cairn_set_up() {
  local -a needed=("${cairn_packages[@]}")
  if [[ ${1:-} == clang ]]; then needed+=("${cairn_clang_packages[@]}"); fi
  if [[ ${1:-} == pages || ${1:-} == book ]]; then needed+=("${cairn_pages_packages[@]}"); fi
  if [[ ${1:-} == book ]]; then needed+=("${cairn_book_packages[@]}"); fi
  if [[ ${1:-} == playground || ${1:-} == web ]]; then needed+=("${cairn_playground_packages[@]}"); fi
  if [[ ${1:-} == web ]]; then needed+=("${cairn_book_packages[@]}"); fi
  if [[ ${1:-} == docs ]]; then needed+=("${cairn_docs_packages[@]}"); fi
  if [[ ${1:-} == bench ]]; then needed+=("${cairn_bench_packages[@]}"); fi
  if [[ ${1:-} == peers ]]; then needed+=("${cairn_peer_packages[@]}"); fi
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    if [[ ! -d $cairn_root/build ]]; then
      printf 'This is neither Debian nor Ubuntu. Cairn needs what they call:\n  %s\n' "${needed[*]}" >&2
    fi
    return 0
  fi
  local -a missing
  mapfile -t missing < <(cairn_missing "${needed[@]}")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  # Nothing to do where all that is missing does not exist in this release.
  local package
  for package in "${missing[@]}"; do
    if [[ $cairn_dispensable != *" $package "* ]] || apt-cache show "$package" >/dev/null 2>&1; then
      cairn_install "${missing[@]}"
      return
    fi
  done
}

# Configures PRESET unless that was done, by this copy of the sources and these presets.
cairn_configure() {
  local build=$cairn_root/build/$1
  local stamp=$build/configured
  local home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null)
  if [[ $cairn_installed == no && -f $build/build.ninja && $home == "$cairn_root" && -f $stamp &&
        ! $cairn_root/CMakePresets.json -nt $stamp && ! $cairn_root/CMakeLists.txt -nt $stamp ]]; then
    return 0
  fi
  mkdir -p "$build"
  if ! (cd "$cairn_root" && cmake --preset "$1" --fresh) >"$build/configure.log" 2>&1; then
    cat "$build/configure.log" >&2
    return 1
  fi
  grep -E '^-- Without ' "$build/configure.log" >&2
  touch "$stamp"
}

# cairn_build PRESET TARGET...: configures and builds; the whole log is in build/PRESET/build.log.
cairn_build() {
  local preset=$1
  shift
  local build=$cairn_root/build/$preset
  # A home that cannot be written to must not stop the compiler cache.
  if [[ ! -w ${HOME:-/nonexistent} ]]; then export CCACHE_DIR="${CCACHE_DIR:-$cairn_root/build/ccache}"; fi
  cairn_configure "$preset" || return 1
  if [[ ! -f $build/built ]]; then printf 'Building in build/%s: some minutes the first time.\n' "$preset" >&2; fi
  NINJA_STATUS='[%f/%t] ' cmake --build "$build" --target "$@" 2>&1 |
    cairn_watch Building "$build/build.log" '^\[([0-9]+)/([0-9]+)\]'
  local code=${PIPESTATUS[0]}
  if [[ $code != 0 ]]; then
    # From the first failure on, without the steps that went well and the compiler's command lines.
    sed -n '/^FAILED: /,$p' "$build/build.log" | grep -vE '^(\[[0-9]+/[0-9]+\]|[^ ]*/(cmake -E env|ccache|run_reader) )' | head -n 60 >&2
    grep -q '^FAILED: ' "$build/build.log" || tail -n 20 "$build/build.log" >&2
    printf 'The build failed (exit code %s). The whole log: build/%s/build.log\n' "$code" "$preset" >&2
    return 1
  fi
  touch "$build/built"
}

if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
  cairn_set_up "$@"
  exit
fi
