#!/usr/bin/env bash
# What smaller beds, shorter windows and longer steps save, and what they change (docs/decisions/0011): the cuts of
# tests/validation/cut/cost.toml, 60 a variant, compared condition by condition with the first. Stop and repeat at will:
# finished cuts stay in FOLDER. Run from the root of the repository; some 30 minutes of one core.
#   tests/validation/cut_cost.sh [FOLDER]        B: the program, JOBS: cuts at a time
set -euo pipefail
out=${1:-try/cut_cost}
source "$(dirname "$0")/vary.sh"
base=$here/cut/cost.toml

height='s/bed_height_depths = .*/bed_height_depths = 3/; s/bed_height_least_mm = .*/bed_height_least_mm = 6/'
behind='s/moving_behind_depths = .*/moving_behind_depths = 2/'
ahead='s/moving_ahead_depths = .*/moving_ahead_depths = 6/; s/moving_ahead_least_mm = .*/moving_ahead_least_mm = 12/'
step='s/step_factor = .*/step_factor = 0.96/'
graded() { # fine depths, least depth [mm]
  echo "s/^bed_beyond_depths/fine_bed_depths = $1\nfine_bed_least_mm = $2\n&/"
}

vary base ''
vary height_3 "$height"
vary behind_2 "$behind"
vary step_0.96 "$step"
vary graded_2 "$(graded 2 4)"
vary graded_1.5 "$(graded 1.5 3)"
vary height_3_step_0.96 "$height; $step"
vary height_3_step_0.96_behind_2 "$height; $step; $behind"
vary height_3_step_0.96_behind_2_graded_1.5 "$height; $step; $behind; $(graded 1.5 3)"
vary height_3_step_0.96_behind_2_graded_1.5_ahead_6 "$height; $step; $behind; $(graded 1.5 3); $ahead"

awk -f "$here/cut_cost.awk" "${rows[@]}"
