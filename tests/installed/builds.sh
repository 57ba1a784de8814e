#!/usr/bin/env bash
# Builds that the ordinary tests do not make: from an archive without git, in a folder with blanks in its path, with g++
# and clang++, with static and with shared libraries. Each is installed, its unit tests of peaks and runtime are run, and
# two examples are built against it. `./run builds`; an hour of two cores without a compiler cache.
#   builds.sh SOURCE [COMPILER-KIND...]   (all: gcc-static gcc-shared clang-static clang-shared)
set -euo pipefail
source=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- gcc-static gcc-shared clang-static clang-shared
git -C "$source" rev-parse HEAD >/dev/null 2>&1 || { echo "$source is no checkout"; exit 77; }
command -v clang++ >/dev/null || { echo "clang++ is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/an archive of bitrock"
mkdir "$tree"
git -C "$source" archive HEAD | tar -x -C "$tree"
[ ! -e "$tree/.git" ]
export CCACHE_BASEDIR=$tree  # where ccache is used, the archive hits what the checkout has compiled

for kind in "$@"; do
  begin=$SECONDS
  case "$kind" in
    gcc-*) compilers=(-DCMAKE_C_COMPILER=gcc -DCMAKE_CXX_COMPILER=g++) ;;
    clang-*) compilers=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++) ;;
    *) echo "$kind (must be gcc-static, gcc-shared, clang-static or clang-shared)"; exit 2 ;;
  esac
  shared=OFF
  [[ $kind != *-shared ]] || shared=ON
  build="$tree/build of $kind"
  cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG" \
    "${compilers[@]}" -DBUILD_SHARED_LIBS=$shared -DBITROCK_BENCH=OFF -DBITROCK_WARNINGS_AS_ERRORS=ON >"$scratch/log"
  # everything that is installed, and some tests
  cmake --build "$build" -j 2 --target bitrock_installed unit_peaks unit_runtime >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; exit 1; }
  "$build/tests/unit_peaks" --gtest_brief=1
  "$build/tests/unit_runtime" --gtest_brief=1
  prefix="$scratch/installed by $kind"
  cmake --install "$build" --prefix "$prefix" >"$scratch/log"
  (cd "$scratch" && "$prefix/bin/bitrock" --version)
  cmake -S "$tree/examples" -B "$build/examples" -G Ninja "${compilers[@]}" -DCMAKE_PREFIX_PATH="$prefix" \
    "-DEXAMPLES=peaks;own_contact_law;bit_force" >"$scratch/log"
  cmake --build "$build/examples" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
  for name in own_contact_law bit_force; do
    "$tree/tests/installed/example.sh" "$tree/examples/README.md" $name "$build/examples/$name"
  done
  "$tree/tests/installed/example.sh" "$tree/examples/README.md" peaks "$build/examples/peaks" \
    "$tree/examples/force_record.csv"
  printf '%s: %d s\n' "$kind" $((SECONDS - begin))
  rm -rf "$build" "$prefix"
done
