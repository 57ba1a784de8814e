#!/usr/bin/env bash
# The cut under mud (docs/results/mud.md): pressure, debris, damping, speed, depth, rake, seal gap and cutter face, each
# varied alone from the cut of tests/validation/cut/mud.toml. Stop and repeat at will: finished cuts stay in FOLDER. Run
# from the root of the repository; with three seeds some 40 minutes of one core, half of them the slow and the deep cuts.
#   tests/validation/mud.sh [FOLDER] | tests/validation/into_page.sh mud docs/results/mud.md
#                     B: the program, JOBS: cuts at a time, SEEDS: e.g. "1, 2, 3" (rocks)
set -euo pipefail
out=${1:-try/mud}
source "$(dirname "$0")/vary.sh"
vary_the_cut_under_mud

key() { echo "s/^$1 = .*/$1 = $2/"; }
pressure() { key pressure_MPa "$1"; }
drained='s/^debris = .*/debris = "drained"/'

vary base ''
for p in 0 2 5 10 40; do vary "pressure $p" "$(pressure $p)"; done
for p in 10 20 40; do vary "drained $p" "$drained; $(pressure $p)"; done
for p in 0 20; do
  for damping in 0.05 0.2; do
    vary "damping $damping at $p MPa" "$(key local_damping $damping); $(pressure $p)"
  done
done
vary "rake 10" "$(key back_rakes_deg '[10]')"
vary "rake 30" "$(key back_rakes_deg '[30]')"
vary "speed 2" "$(key cutter_speeds_m_per_s '[2]')"
vary "speed 0.25" "$(key cutter_speeds_m_per_s '[0.25]')"
vary "seal gap 0.02" "$(key seal_gap_over_radius 0.02)"
vary "seal gap 0.2" "$(key seal_gap_over_radius 0.2)"
vary "face sealed" "s/^cutter_face = .*/cutter_face = \"sealed\"/"
vary "bed 8 depths high" "$(key bed_height_depths 8)"
vary "window 20 depths ahead" "$(key moving_ahead_depths 20); $(key bed_beyond_depths 20)"
vary "depth 1" "$(key depths_of_cut_mm '[1]')"
vary "depth 4" "$(key depths_of_cut_mm '[4]')"

awk -v ucs_Pa=70.5e6 -f "$here/mud.awk" "${rows[@]}"
