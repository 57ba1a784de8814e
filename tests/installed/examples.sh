#!/usr/bin/env bash
# Builds all examples against an installed bitrock; warnings are errors. Each has at most 80 lines.
#   examples.sh PREFIX CMAKE EXAMPLES BUILD
set -euo pipefail
for file in "$3"/*.c "$3"/*.cpp; do
  lines=$(wc -l <"$file")
  [ "$lines" -le 80 ] || { echo "$file has $lines lines (at most 80)"; exit 1; }
done
rm -rf "$4"
"$2" -S "$3" -B "$4" -DCMAKE_PREFIX_PATH="$1" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror -Wno-missing-field-initializers" -DCMAKE_C_FLAGS="-Wall -Wextra -Wpedantic -Werror" >/dev/null
"$2" --build "$4" -j 2
