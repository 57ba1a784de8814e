#!/usr/bin/env bash
# `cmake --install` of a build of which parts are missing writes nothing and says what to build; the target it names
# builds all that is installed.
#   partial.sh SOURCE CMAKE
set -euo pipefail
source=$(cd "$1" && pwd)
cmake=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
build=$scratch/build
fail() { printf '%s\n' "$1"; cat "$scratch/log"; exit 1; }

"$cmake" -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBITROCK_TESTS=OFF >"$scratch/log" 2>&1 ||
  fail "configuring failed"
if "$cmake" --install "$build" --prefix "$scratch/prefix" >"$scratch/log" 2>&1; then fail "nothing is built, and it was installed"; fi
for words in "bitrock is not wholly built" "$build/cli/bitrock" "libbitrock_runtime.so" "--target bitrock_installed" "./run install PREFIX"; do
  grep -qF -- "$words" "$scratch/log" || fail "the message does not say: $words"
done
[ ! -e "$scratch/prefix" ] || fail "parts were installed"

# What the rules of installing take from the build folder, pages and package files aside, is what is asked for.
find "$build" -name cmake_install.cmake -exec grep -ohE "FILES \"$build/[^\"]*\"" {} + | sed 's/^FILES "//; s/"$//' |
  grep -vE '/package/|/Export/' | sort -u >"$scratch/installed"
sed -n 's/^  "\(.*\)"$/\1/p' "$build/package/whole_Release.cmake" | sort -u >"$scratch/asked"
diff "$scratch/installed" "$scratch/asked" >"$scratch/log" || fail "installed (<), and looked for before it (>)"
grep -q libbitrock_runtime.so "$scratch/asked" || fail "no libbitrock_runtime.so among what is installed"
"$cmake" --build "$build" --target help >"$scratch/log" 2>&1
grep -q '^bitrock_installed:' "$scratch/log" || fail "there is no target bitrock_installed"

# All there: nothing is said.
xargs -d '\n' dirname <"$scratch/asked" | sort -u | xargs -d '\n' mkdir -p
xargs -d '\n' touch <"$scratch/asked"
"$cmake" -P "$build/package/whole_Release.cmake" >"$scratch/log" 2>&1 || fail "all is there, and it is refused"
