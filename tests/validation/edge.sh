#!/usr/bin/env bash
# The edge of the cutter (docs/results/mud.md): clearance, chamfer, wear flat and friction, each varied alone from the cut
# of tests/validation/cut/mud.toml, with mud and without; and what each wear flat carries. Stop and repeat at will:
# finished cuts stay in FOLDER. Run from the root of the repository; with three seeds some 15 minutes of one core.
#   tests/validation/edge.sh [FOLDER] | tests/validation/into_page.sh edge docs/results/mud.md
#                     B: the program, JOBS: cuts at a time, SEEDS: e.g. "1, 2, 3" (rocks)
set -euo pipefail
out=${1:-try/edge}
source "$(dirname "$0")/vary.sh"
vary_the_cut_under_mud

cutter() { echo "s/^thickness_mm = .*/&\n$1 = $2/"; }
dry='s/^pressure_MPa = .*/pressure_MPa = 0/'

vary base ''
for angle in 5 10 40; do vary "clearance $angle" "$(cutter clearance_deg $angle)"; done
for length in 0.2 0.4; do vary "chamfer $length" "$(cutter chamfer_mm $length)"; done
for length in 0.5 1 2; do vary "flat $length" "$(cutter wear_flat_mm $length)"; done
vary "friction 0.6" 's/^friction_coefficient = .*/friction_coefficient = 0.6/'
vary "dry" "$dry"
vary "dry, clearance 10" "$dry; $(cutter clearance_deg 10)"
vary "dry, chamfer 0.4" "$dry; $(cutter chamfer_mm 0.4)"
vary "dry, flat 1" "$dry; $(cutter wear_flat_mm 1)"

awk -v ucs_Pa=70.5e6 -f "$here/mud.awk" "${rows[@]}"
awk -v ucs_Pa=70.5e6 -f "$here/edge.awk" "${rows[@]}"
