#!/usr/bin/env bash
# Puts tables where they belong in docs/results/validation.md: what comes in replaces the lines between <!-- NAME --> and
# <!-- end of NAME -->.
#   tests/validation/cut_trends.sh FEATURES.csv | tests/validation/into_page.sh cut_trends
set -euo pipefail
name=${1:?usage: into_page.sh NAME [PAGE]}
page=${2:-docs/results/validation.md}
for mark in "<!-- $name -->" "<!-- end of $name -->"; do
  grep -qxF -- "$mark" "$page" || { echo "into_page: $page has no line $mark" >&2; exit 2; }
done
table=$(mktemp)
trap 'rm -f "$table"' EXIT
cat >"$table"
[ -s "$table" ] || { echo "into_page: nothing came in" >&2; exit 2; }
awk -v name="$name" -v table="$table" '
  $0 == "<!-- end of " name " -->" { skipping = 0 }
  !skipping { print }
  $0 == "<!-- " name " -->" {
    while ((getline line < table) > 0) print line
    skipping = 1
  }' "$page" >"$page.part"
mv "$page.part" "$page"
