#!/usr/bin/env bash
# What tables of cuts say about rock cutting (docs/results/validation.md): specific energy over rake and depth, direction of the
# force, speed, chips, as markdown with standard errors; with -o also the figure cut_trends.png.
#   tests/validation/cut_trends.sh [-o FOLDER] [-u UCS_MPa] [-g GRAIN_mm] [-f FRICTION] FEATURES.csv...
# FEATURES.csv is one row a cut, as `bitrock campaign collect` writes it; the same row in two files counts once.
set -euo pipefail
here=$(dirname "$0")
folder='' ucs=70.5 grain=0.5 friction=0.3
while getopts 'o:u:g:f:' option; do
  case $option in
    o) folder=$OPTARG ;;
    u) ucs=$OPTARG ;;
    g) grain=$OPTARG ;;
    f) friction=$OPTARG ;;
    *) sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
for file in "$@"; do [ -r "$file" ] || { echo "cut_trends: cannot read $file" >&2; exit 2; }; done

plots=''
if [ -n "$folder" ]; then
  mkdir -p "$folder"
  plots=$(mktemp -d)
  trap 'rm -rf "$plots"' EXIT
fi
friction_angle=$(awk -v f="$friction" 'BEGIN { print atan2(f, 1) * 180 / atan2(0, -1) }')
awk -v ucs="$ucs" -v grain="$grain" -v friction_angle="$friction_angle" -v plots="$plots" \
  -f "$here/cut_trends.awk" "$@"
if [ -n "$folder" ]; then
  gnuplot -e "data='$plots'; picture='$folder/cut_trends.png'; friction_angle=$friction_angle" "$here/cut_trends.gnuplot"
fi
