#!/bin/sh
# How near the rebuilt force comes to the DEM's over a data set, in all modes, from the cuts' own statistics and from
# networks. Writes the tables of docs/results/rebuild.md; a page and the JSON stay in FOLDER.
#   tests/validation/rebuild.sh BITROCK FOLDER FORCES.h5 [MODEL.json] | tests/validation/into_page.sh rebuild docs/results/rebuild.md
# An hour of one core for 240 cases (DRAWS=600); DRAWS=64 is quick and scatters by 2 % in the mean.
set -eu
bitrock=$1 folder=$2 forces=$3 model=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$folder"
"$bitrock" rebuild "$forces" ${model:+--model "$model"} --mode sawtooth --mode article --mode article-literal \
  --draws "${DRAWS:-600}" --json "$folder/rebuild.json" --report "$folder/rebuild.html" --quiet
/usr/bin/python3 "$here/rebuild.py" "$folder/rebuild.json"
