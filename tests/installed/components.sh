#!/usr/bin/env bash
# find_package(bitrock COMPONENTS ...) asks for what the components need and nothing else.
#   components.sh PREFIX CMAKE EXAMPLES   (the folder of the examples, of which `peaks` is the user of one component)
set -euo pipefail
prefix=$(cd "$1" && pwd)
cmake=$2
examples=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
package=$(dirname "$(find "$prefix" -name bitrock-config.cmake)")

fail() { printf '%s\n' "$1"; [ ! -f "$scratch/log" ] || cat "$scratch/log"; exit 1; }

# Packages that a component's file names, and those of the components it includes.
packages_of() {
  local file=$package/bitrock-$1.cmake
  sed -n 's/^find_dependency(\([A-Za-z0-9]*\).*/\1/p' "$file"
  sed -n 's/^include(.*\/bitrock-\(.*\)\.cmake")$/\1/p' "$file" | grep -v -- '-targets$' | while read -r other; do
    packages_of "$other"
  done
}
without_others() {  # options of CMake that hide every package but these
  local every
  every=$(sed -n 's/^find_dependency(\([A-Za-z0-9]*\).*/\1/p' "$package"/bitrock-*.cmake | sort -u)
  for name in CLI11 Eigen3 PkgConfig nlohmann_json $every; do
    grep -qxF "$name" <<<"$1" || printf -- '-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON\n' "$name"
  done
}
# configure FOLDER BUILD OPTION...
configure() {
  "$cmake" -S "$1" -B "$scratch/$2" -DCMAKE_PREFIX_PATH="$prefix" "${@:3}" >"$scratch/log" 2>&1
}
# A project that asks for one component. asking COMPONENT LANGUAGES
asking() {
  mkdir -p "$scratch/asks_$1"
  printf 'cmake_minimum_required(VERSION 3.25)\nproject(asks LANGUAGES %s)\nfind_package(bitrock REQUIRED COMPONENTS %s)\n' \
    "$2" "$1" >"$scratch/asks_$1/CMakeLists.txt"
  printf 'get_target_property(links bitrock::%s INTERFACE_LINK_LIBRARIES)\nmessage(STATUS "links ${links}")\n' "$1" \
    >>"$scratch/asks_$1/CMakeLists.txt"
}

# Peaks alone: built, linked and run with everything else out of reach.
mapfile -t hidden < <(without_others "$(packages_of peaks)")
[ ${#hidden[@]} -ge 8 ] || fail "few packages are hidden: ${hidden[*]}"
configure "$examples" peaks -DEXAMPLES=peaks "${hidden[@]}" || fail "peaks asks for more than it needs"
"$cmake" --build "$scratch/peaks" >"$scratch/log" 2>&1 || fail "peaks does not link"
"$scratch/peaks/peaks" "$examples/force_record.csv" | grep -q '^highest peak' || fail "peaks does not run"

# The same out of reach, what needs it is refused, and the message says what is missing.
if configure "$examples" cut -DEXAMPLES=cut "${hidden[@]}"; then fail "dem2d was found without its packages"; fi
grep -q HDF5 "$scratch/log" || fail "the message does not name what dem2d misses"

# Every component with its own packages alone.
for file in "$package"/bitrock-*-targets.cmake; do
  name=$(basename "$file" -targets.cmake)
  name=${name#bitrock-}
  asking "$name" "C CXX"
  mapfile -t hidden < <(without_others "$(packages_of "$name")")
  configure "$scratch/asks_$name" "build_$name" "${hidden[@]}" || fail "$name asks for a package that it does not name"
done
for pair in surrogate_net:OpenMP surrogate:OpenMP runtime:OpenMP runtime_shared:HDF5 dem2d:Eigen3 dem2d:cairo; do
  ! packages_of "${pair%%:*}" | grep -qxF "${pair##*:}" || fail "${pair%%:*} asks for ${pair##*:}"
done

# The C interface in a project without C++.
asking runtime_shared C
configure "$scratch/asks_runtime_shared" c_only || fail "runtime_shared is not found by a project in C"

# A component that does not exist.
asking drilling_mud "C CXX"
if configure "$scratch/asks_drilling_mud" unknown; then fail "an unknown component was found"; fi
tr '\n' ' ' <"$scratch/log" | tr -s ' ' | grep -q "bitrock has no component 'drilling_mud' (it has base, " ||
  fail "the message does not say which components there are"
sed -i 's/REQUIRED COMPONENTS/OPTIONAL_COMPONENTS peaks/; /get_target/,$d' "$scratch/asks_drilling_mud/CMakeLists.txt"
echo 'if(bitrock_drilling_mud_FOUND OR NOT bitrock_peaks_FOUND)
  message(FATAL_ERROR "what was found is not said")
endif()' >>"$scratch/asks_drilling_mud/CMakeLists.txt"
configure "$scratch/asks_drilling_mud" optional || fail "an optional component that does not exist"
