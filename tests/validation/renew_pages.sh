#!/usr/bin/env bash
# Everything in the repository that follows from the data set, made anew when the data set has changed: trends of the cut,
# networks (model.json) and their parity pictures, the three drilling cases, the map and the pictures of the drill string.
# Tables go into docs/results/validation.md, pictures into docs/figures. The prose around the tables is yours: read it afterwards.
# Intermediate files are kept in FOLDER; two minutes of two cores. B: the program.
#   tests/validation/renew_pages.sh [FOLDER]
set -euo pipefail
export B=${B:-build/release/cli/bitrock}
out=${1:-try/renew_pages}
here=tests/validation data=campaigns/paper240 figures=docs/figures
mkdir -p "$out"
stage() { printf '== %s (%d s)\n' "$1" $SECONDS >&2; }

stage "Trends of the cut"
$here/cut_trends.sh -o $figures $data/features.csv campaigns/six_mm/features.csv >"$out/cut_trends.md"
$here/into_page.sh cut_trends <"$out/cut_trends.md"

stage "Networks"
$here/networks.sh "$out/networks" $data/features.csv >"$out/networks.md"
$here/into_page.sh networks <"$out/networks.md"
cp "$out/networks/model.json" $data/model.json
cp "$out/networks/parity_x.png" "$out/networks/parity_y.png" $figures/

stage "Drill string: three cases, what decides, map"
$here/drill_cases.sh "$out/drill_cases" $data/model.json >"$out/drill_cases.md"
$here/into_page.sh drill_cases <"$out/drill_cases.md"
cp "$out/drill_cases/stick_slip_map.png" $figures/

stage "Drill runs"
for case in normal stick_slip bit_bounce; do
  "$B" drill run campaigns/drill/$case.toml --model $data/model.json -o "$out/$case.h5" --quiet
  "$B" report "$out/$case.h5" -o "$out/$case.html" --figures "$out/$case" --quiet
  cp "$out/$case/drill_run.png" $figures/drill_$case.png
done
stage "Done. Read docs/results/validation.md: does the prose still tell what the tables say?"
