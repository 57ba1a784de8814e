#!/bin/sh
# Fails on a source file that no CMakeLists.txt (nor *.cmake) names: it would never be compiled, and a test in it never
# run. Usage: sources_listed.sh ROOT
set -eu
cd "$1"
named=$(mktemp)
trap 'rm -f "$named"' EXIT

files() {
  find . \( -name .git -o -path ./build -o -path ./try -o -path ./demo \) -prune -o -type f \( "$@" \) -print | sort
}

# What the build files name, as paths from the root. A name is taken from the folder of the build file and from all above,
# for an included *.cmake speaks of the folder that includes it.
files -name CMakeLists.txt -o -name '*.cmake' | while read -r list; do
  sed 's/#.*//; s/\${[A-Z_]*_DIR}\///' "$list" | grep -oE '[A-Za-z0-9_./-]+\.(cpp|c)\b' |
    awk -v folder="${list%/*}" '{ for (above = folder; ; sub("/[^/]*$", "", above)) { print above "/" $0; if (above !~ "/") break } }' ||
    true
done | sort -u >"$named"

missing=$(files -name '*.cpp' -o -name '*.c' | grep -vxFf "$named" || true)
[ -n "$missing" ] || exit 0
printf '%s\n' "$missing" | sed 's|^\./||; s|$|   (no CMakeLists.txt names it: it is never compiled)|'
exit 1
