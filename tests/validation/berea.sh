#!/usr/bin/env bash
# The cut of a Berea-like rock against the cutter tests in Berea sandstone that are published (docs/results/mud.md,
# "Against measured cuts"): the depths that were measured, and one thing varied at a time at 2.03 mm. Stop and repeat at
# will: finished cuts stay in FOLDER. Run from the root of the repository; with three seeds an hour of one core.
#   tests/validation/berea.sh [FOLDER] | tests/validation/into_page.sh berea docs/results/mud.md
#                     B: the program, JOBS: cuts at a time, SEEDS: e.g. "1, 2, 3" (rocks)
#
# The rock: campaigns/rocks/sandstone.toml with every stress times 49.0 / 34.41, which makes its strength that of the
# Berea tested (7100 psi, 49.0 MPa [AtashnezhadCutter]), and every length times 0.4, which makes its grains 0.5 mm. Both
# are exact similarities: E 11.7 GPa, tensile strength 4.4 MPa, nu 0.17, disc by disc as in the sandstone.
set -euo pipefail
out=${1:-try/berea}
source "$(dirname "$0")/vary.sh"
base=$out/cut_in_berea.toml
sed "s/^seeds = .*/seeds = [${SEEDS:-1, 2, 3}]/" "$here/cut/berea.toml" >"$base"

ucs_MPa=49.0
awk -v stress="$(awk -v ucs=$ucs_MPa 'BEGIN { print ucs / 34.41 }')" '
  /^#/ { next }
  /^name/ { print "name = \"Berea-like sandstone\""; next }
  /^[a-z_]+_[MG]Pa = / { printf "%s = %.9g\n", $1, $3 * stress; next }
  /^[a-z_]+_mm = / { printf "%s = %.9g\n", $1, $3 * 0.4; next }
  { print }' campaigns/rocks/sandstone.toml >"$out/rocks/berea_like.toml"

key() { echo "s/^$1 = .*/$1 = $2/"; }
cutter() { echo "s/^thickness_mm = .*/&\n$1 = $2/"; }
other_rock() { # name, awk program over the rock file; prints the expression of the study
  awk "$2 { print }" "$out/rocks/berea_like.toml" >"$out/rocks/$1.toml"
  ! cmp -s "$out/rocks/$1.toml" "$out/rocks/berea_like.toml" || { echo "berea.sh: rock $1 is the same" >&2; exit 1; }
  echo "s|OWN/berea_like|OWN/$1|"
}

vary base ''
for depth in 0.53 1.05 1.55; do vary "depth $depth" "$(key depths_of_cut_mm "[$depth]")"; done
for depth in 0.53 1.05 2.03; do
  vary "depth $depth at 0.05 m per s" "$(key depths_of_cut_mm "[$depth]"); $(key cutter_speeds_m_per_s '[0.05]')"
done
vary "speed 0.5" "$(key cutter_speeds_m_per_s '[0.5]')"
vary "rock five times softer" "$(other_rock soft '/^\[/ { table = $1 }
  table != "[packing]" && /^effective_modulus_GPa/ { $3 /= 5 }')"
vary "tension softens, 9" "$(other_rock tough '/^elements/ { $0 = $0 "\ntension_softening = 9" }')"
vary "debris friction 1.0" "$(other_rock rough '/^\[/ { table = $1 }
  table == "[linear_contacts]" && /^friction_coefficient/ { $3 = 1 }')"
vary "clearance 5" "$(cutter clearance_deg 5)"
vary "chamfer 0.4" "$(cutter chamfer_mm 0.4)"
vary "wear flat 0.5" "$(cutter wear_flat_mm 0.5)"
vary "cutter friction 0.6" "$(key friction_coefficient 0.6)"
vary "damping 0.2" "$(key local_damping 0.2)"
vary "debris gone half a millimetre above the rock" "$(key domain_margin_mm 0.5)"
for p in 5 20; do # in a bed and a window as tests/validation/cut/mud.toml has them
  vary "mud of $p MPa" "s/^domain_margin_mm.*/&\n\n[fluid]\npressure_MPa = $p\ndebris = \"sealed\"/
    $(key bed_height_depths 5); $(key moving_ahead_depths 12); $(key bed_beyond_depths 12)"
done

awk -v ucs_Pa=${ucs_MPa}e6 -v base_name="**2.03 mm, 0.25 m/s**" -f "$here/mud.awk" "${rows[@]}"
