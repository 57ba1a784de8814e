#!/usr/bin/env bash
# What the forces of a cut depend on besides the rock and the cut itself (docs/results/validation.md): one change of
# tests/validation/cut/base.toml at a time, eight rocks each. Stop and repeat at will: finished cuts stay in FOLDER.
# Run from the root of the repository; some 20 minutes of one core.
#   tests/validation/cut_sensitivity.sh [FOLDER]        B: the program, JOBS: cuts at a time
set -euo pipefail
out=${1:-try/cut_sensitivity}
source "$(dirname "$0")/vary.sh"

# Everything the size of the grains enters: radii and installation gap.
grains() { # factor, target
  awk -v factor="$1" '/^(radius_min_mm|radius_max_mm|installation_gap_mm) =/ { $3 *= factor } { print }' \
    "$rocks/article_fine.toml" >"$2"
}
grains 0.5 "$out/rocks/half_grains.toml"
grains 2 "$out/rocks/double_grains.toml"

base=$here/cut/base.toml

vary base ''
for alpha in 0 0.02 0.05 0.2 0.5 0.7; do vary damping_$alpha "s/local_damping = .*/local_damping = $alpha/"; done
vary grain_1mm 's|ROCKS/article_fine.toml|OWN/double_grains.toml|'
vary moving_4_2 's/moving_ahead_depths = 8/moving_ahead_depths = 4/; s/moving_behind_depths = 4/moving_behind_depths = 2/'
vary moving_6_3 's/moving_ahead_depths = 8/moving_ahead_depths = 6/; s/moving_behind_depths = 4/moving_behind_depths = 3/'
vary moving_12_6 's/moving_ahead_depths = 8/moving_ahead_depths = 12/; s/moving_behind_depths = 4/moving_behind_depths = 6/'
vary moving_all '/^moving_/d'
for depths in 3 6 8; do vary bed_height_$depths "s/bed_height_depths = .*/bed_height_depths = $depths/"; done
for friction in 0.1 0.5; do vary friction_$friction "s/friction_coefficient = .*/friction_coefficient = $friction/"; done
for depths in 11 44; do vary cut_length_$depths "s/cut_length_depths = .*/cut_length_depths = $depths/"; done
for um in 5 10 40; do vary sampling_${um}um "s/sampling_distance_um = .*/sampling_distance_um = $um/"; done
vary grain_0.25mm 's|ROCKS/article_fine.toml|OWN/half_grains.toml|; s/^seeds = .*/seeds = [1, 2, 3, 4]/'  # eight times the work

awk -f "$here/cut_sensitivity.awk" "${rows[@]}"
