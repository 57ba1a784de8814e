#!/usr/bin/env bash
# cut_cost.awk must find what was put in: made-up cuts whose second study is 5 % higher in F_x, costs half, and scatters
# by a known amount.
set -euo pipefail
table=$(dirname "$0")/cut_cost.awk
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/base" "$folder/other"

# Two conditions, two seeds each, F_x = 1000 F exp(+-s): within a condition the variance of the logarithm is 2 s^2, and
# the error of the difference of two means over two conditions is sqrt(2 s^2 (1/2 + 1/2) / 2) = s.
make_up() { # factor on F_x, s, core seconds
  awk -v factor="$1" -v s="$2" -v core="$3" 'BEGIN {
    print "cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,x_amax_N_per_m,x_amean_N_per_m,x_np1,x_np23," \
          "x_np4,x_mean_N_per_m,y_mean_N_per_m,chips,energy_residual_fraction,core_s"
    for (depth = 1; depth <= 2; ++depth) for (sign = -1; sign <= 1; sign += 2) {
      printf "2,%d,15,0.044,9e5,9e4,100,50,20,%.17g,500,%d,%g,%g\n", depth, 1000 * depth * factor * exp(sign * s), 0,
             sign * 2e-4, core
    }
  }'
}
make_up 1 0.1 4 >"$folder/base/features.csv"
make_up "$(awk 'BEGIN { print exp(0.05) }')" 0.1 2 >"$folder/other/features.csv"
awk -f "$table" "$folder/base/features.csv" "$folder/other/features.csv" >"$folder/out"
expect() {
  grep -qF -- "$1" "$folder/out" || { echo "cut_cost_self_test: missing: $1" >&2; cat "$folder/out" >&2; exit 1; }
}
expect "| base | 4 | 1.00 | 0.020 % |"
expect "| other | 4 | 0.50 | 0.020 % | +5.0 ± 10.0 % (+0.5) | +0.0 ± 0.0 % |"
echo "cut_cost_self_test: passed"
