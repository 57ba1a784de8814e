#!/usr/bin/env bash
# Chips and independent stretches of a cut over the pressure of the mud (docs/results/mud.md): the cut of
# tests/validation/cut/mud.toml, 20 depths long. Stretches: length of cut over twice the correlation length of the force
# along the cut. Stop and repeat at will: finished cuts stay in FOLDER. Run from the root of the repository; ten minutes of
# one core.
#   tests/validation/chips.sh [FOLDER] | tests/validation/into_page.sh chips docs/results/mud.md
#                     B: the program, JOBS: cuts at a time, SEEDS: e.g. "1, 2, 3" (rocks)
set -euo pipefail
out=${1:-try/chips}
source "$(dirname "$0")/vary.sh"
vary_the_cut_under_mud

vary base ''
for p in 0 5; do vary "$p" "s/^pressure_MPa = .*/pressure_MPa = $p/"; done

awk '
  function both(sum, squares) { return sprintf("%.1f +- %.1f", sum / n, sqrt((squares - sum * sum / n) / (n - 1) / n)) }
  function row() {
    if (n > 1) printf "| %g | %d | %s | %s |\n", pressure, n, both(chips, chips2), both(pieces, pieces2)
    n = chips = chips2 = pieces = pieces2 = 0
  }
  BEGIN {
    FS = ","
    print "| pressure, MPa | rocks | chips | independent stretches |"
    print "|---|---|---|---|"
  }
  FNR == 1 { row(); for (i = 1; i <= NF; ++i) at[$i] = i; next }
  {
    ++n
    pressure = $(at["fluid_pressure_MPa"])
    c = $(at["chips"]); chips += c; chips2 += c * c
    p = 1e3 * $(at["cut_length_m"]) / (2 * $(at["correlation_length_mm"])); pieces += p; pieces2 += p * p
  }
  END { row() }' "$out/0/features.csv" "$out/5/features.csv" "$out/base/features.csv"
