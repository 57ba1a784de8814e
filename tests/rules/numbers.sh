#!/bin/sh
# Fails on numbers and JSON that are read loosely: these functions take 010 for eight, 0x14 for twenty, the 1 of `1e`, or
# the last of two keys. base/number.hpp and base/json.hpp do not. Usage: numbers.sh ROOT
set -eu
cd "$1"
loose='(^|[^A-Za-z0-9_])([sf]?scanf|ato[fil]|strto(d|f|ld|l|ul|ll|ull)|sto(i|l|ll|ul|ull|f|d|ld)|lexical_cast|json::parse) *[(<]'
# the C file that is exported checks the rest of its line
found=$(grep -rnE "$loose" --include='*.cpp' --include='*.hpp' base cli dem2d peaks python report runtime studies surrogate views |
  grep -v -e '^base/json.cpp:' -e '^surrogate/export/c_source.cpp:' || true)
[ -z "$found" ] && exit 0
printf '%s\n' "$found"
echo "read numbers by base/number.hpp and JSON by base/json.hpp"
exit 1
