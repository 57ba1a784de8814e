#!/usr/bin/env bash
# Runs an example and compares what it prints with what examples/README.md says it prints, to the letter: bitrock gives
# the same bits on every machine with the same mathematics library.
#   example.sh README NAME PROGRAM ARGUMENT...
set -euo pipefail
readme=$1
name=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
awk -v head="## $name" '
  $0 == head { here = 1 }
  here && /^```text$/ { inside = 1; next }
  inside && /^```$/ { exit }
  inside { print }' "$readme" >"$scratch/expected"
[ -s "$scratch/expected" ] || { echo "$readme does not say what $name prints (## $name, then a block \`\`\`text)"; exit 1; }
"$@" >"$scratch/printed"
diff "$scratch/expected" "$scratch/printed"
