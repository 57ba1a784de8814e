#!/bin/sh
# Fails on a key of an input file that docs/reference/keys.md does not have: the page is not made from its list.
# Usage: keys_documented.sh ROOT
# Keys are found where the readers describe them: {"key_unit", &target, ... (base/config.hpp). features.cpp, folder.cpp
# and drill_file.cpp describe in the same way what bitrock itself writes.
set -eu
cd "$1"
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT
grep '^|' docs/reference/keys.md | grep -oE '[A-Za-z0-9_.]+' | sed 's/.*\.//' | sort -u >"$tables"
found=0
for key in $(find base dem2d runtime studies -name '*.cpp' \
  ! -name features.cpp ! -name folder.cpp ! -name drill_file.cpp -exec grep -ohE '\{"[a-z][A-Za-z0-9_]*", &' {} + 2>/dev/null |
  sed 's/{"//; s/", &//' | sort -u); do
  grep -qxF "$key" "$tables" || { echo "$key   (a key of an input file that docs/reference/keys.md does not have)"; found=1; }
done
exit $found
