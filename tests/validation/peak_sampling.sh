#!/bin/sh
# How the numbers of peaks depend on the sampling, by both definitions: cuts sampled every 5 um, and the same histories by
# means over 10, 20 and 40 um. Writes the table of docs/results/peaks.md.
#   tests/validation/peak_sampling.sh BITROCK FOLDER   (some 20 minutes of two cores; goes on after a stop)
# The environment holds the Python package: PYTHONPATH=build/release/python
set -eu
bitrock=$1 folder=$2 source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$folder"
sed -e 's/^seeds = .*/seeds = [1, 2]/' -e "s#^rock = \"#rock = \"$source/campaigns/#" \
  -e 's/^cutter_speeds.*/cutter_speeds_m_per_s = [0.5, 2]/' -e 's/^depths_of.*/depths_of_cut_mm = [0.5, 1, 2, 5]/' \
  -e 's/^back_rakes.*/back_rakes_deg = [20]/' -e 's/^sampling_distance_um = .*/sampling_distance_um = 5/' \
  "$source/campaigns/paper240.toml" >"$folder/study.in.toml"
"$bitrock" campaign run "$folder/study.in.toml" --dir "$folder/cuts"
"$bitrock" campaign collect "$folder/study.in.toml" --dir "$folder/cuts" --quiet
/usr/bin/python3 "$source/tests/validation/peak_sampling.py" "$folder"/cuts/runs/*.h5
