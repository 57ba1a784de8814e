#!/usr/bin/env bash
# CMake without a preset and without a build type compiles with optimisation, and says so; a type that is given stays.
#   build_type.sh SOURCE [CMAKE]
set -euo pipefail
source=$1
cmake=${2:-cmake}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset CMAKE_BUILD_TYPE  # CMake takes it from the environment, too

# The root file alone decides; the modules below it are left out.
mkdir "$scratch/tree"
sed -e '/find_package\|pkg_check_modules\|add_subdirectory\|^ *include(/d' "$source/CMakeLists.txt" >"$scratch/tree/CMakeLists.txt"

type_of() {
  "$cmake" -S "$scratch/tree" -B "$scratch/$1" -G "Unix Makefiles" -DBITROCK_TESTS=OFF "${@:2}" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; exit 1; }
  sed -n 's/^CMAKE_BUILD_TYPE:[A-Z]*=//p' "$scratch/$1/CMakeCache.txt"
}
failures=0
expect() {
  [ "$1" = "$2" ] || { echo "$3: '$1' (wanted is '$2')"; failures=1; }
}
expect "$(type_of none)" Release "nothing was said"
grep -q "Build type: Release" "$scratch/log" || { echo "no word about it"; failures=1; }
expect "$(type_of none)" Release "configured again"
expect "$(type_of empty -DCMAKE_BUILD_TYPE=)" Release "an empty type"
expect "$(type_of debug -DCMAKE_BUILD_TYPE=Debug)" Debug "a type that was given"
exit $failures
