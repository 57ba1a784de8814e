#!/bin/sh
# The rule must catch what it is for: a key that a reader takes and the page does not have.
set -eu
rule=$(dirname "$0")/keys_documented.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/base" "$house/studies" "$house/dem2d" "$house/runtime" "$house/docs/reference"
printf '# Keys\n## Cut\n| `cut.depth_mm` | of the cutter |\n| `cut.speed_m_per_s` | of the cutter |\nnot a table: rake_deg\n' \
  >"$house/docs/reference/keys.md"
echo 'fill({{"depth_mm", &depth, mm}, {"speed_m_per_s", &speed, 1.0}});' >"$house/dem2d/cut.cpp"
"$rule" "$house"
for key in rake_deg depth; do
  echo "fill({{\"$key\", &value, 1.0}});" >"$house/dem2d/more.cpp"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $key"
    exit 1
  fi
done
