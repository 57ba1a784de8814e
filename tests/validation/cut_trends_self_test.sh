#!/usr/bin/env bash
# cut_trends.sh must find what was put in: made-up cuts with a known psi, power, slope over rake and effect of speed; first
# exact, then with a scatter of 10 %, then with a break.
set -euo pipefail
trends=$(dirname "$0")/cut_trends.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# E = 30 MPa depth^-n (1 + 0.01 (rake - 20)), or the size effect law with d0 = 0.8 mm in place of the power;
# F_y = F_x tan(rake + 7.5 degrees); forces at 0.1 m/s a fifth larger, at 2 m/s a tenth. With a break: n below 2 mm, 0.6
# above. Scatter: a fixed sequence of sums of three throws, of standard deviation 1.
make_up() { # power, power above 2 mm, scatter
  awk -v n="$1" -v above="$2" -v scatter="$3" '
    function throw() { state = (state * 16807) % 2147483647; return state / 2147483647 }
    function normal() { return 2 * (throw() + throw() + throw() - 1.5) }
    BEGIN {
      state = 12345
      pi = atan2(0, -1)
      print "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,x_amax_N_per_m,x_mean_N_per_m," \
            "y_mean_N_per_m,chips,cracks_tensile,cracks_shear,hash"
      speeds = split("0.1 0.5 1 2", speed, " ")
      depths = split("0.5 1 2 3 4 5", depth, " ")
      for (a = 1; a <= speeds; ++a) for (b = 1; b <= depths; ++b) for (rake = 10; rake <= 30; rake += 5) {
        for (seed = 1; seed <= 3; ++seed) {
          d = depth[b]
          e = n == "size" ? 1 / sqrt(1 + d / 0.8) : d > 2 ? 2 ^ -n * (d / 2) ^ -above : d ^ -n
          x = 30e3 * d * e * (1 + 0.01 * (rake - 20)) * (speed[a] == 0.1 ? 1.2 : speed[a] == 2 ? 1.1 : 1) * (1 + scatter * normal())
          angle = (rake + 7.5) * pi / 180
          y = x * sin(angle) / cos(angle) * (1 + scatter * normal())
          printf "1,%d,%s,%s,%d,%.17g,%.17g,%.17g,%.17g,%d,%d,%d,%016d\n", seed, speed[a], d, rake, 0.022 * d, 8 * x, x, y, 20, \
                 speed[a] == 2 ? 120 : 90, 10, ++row
        }
      }
    }'
}

fail() {
  echo "cut_trends_self_test: $1" >&2
  cat "$folder/out" >&2
  exit 1
}
expect() { grep -qF -- "$1" "$folder/out" || fail "missing: $1"; }
# the number after the words must be within the allowed distance of the value
expect_near() { # words, value, allowed
  local found
  found=$(grep -o -- "$1[-0-9.]*" "$folder/out" | head -n 1 | sed "s/.*[^-0-9.]//")
  awk -v found="$found" -v value="$2" -v allowed="$3" \
    'BEGIN { d = found - value; exit !(found != "" && d <= allowed && d >= -allowed) }' ||
    fail "$1$found (expected $2, allowed $3 beside it)"
}

make_up 0.4 0.4 0 >"$folder/exact.csv"
"$trends" "$folder/exact.csv" "$folder/exact.csv" >"$folder/out"
expect "360 cuts, 120 cases; speeds 0.1, 0.5, 1, 2 m/s."  # the same file twice is the same cuts
expect "psi = 7.50 ± 0.00 degrees, R2 = 1.000"
expect "grows by 1.00 ± 0.00 degrees for each degree of rake"
expect "psi = 7.50 degrees, f = 0.00 kN/m, R2 = 1.000"
expect "n = 0.400 ± 0.000"
expect "Slope over rake: 10.0 ± 0.0 % per 10 degrees; E rises in 72 of 72 groups"
# 30 MPa x 2^-0.4 x 0.9 over 70.5 MPa is 0.2902; at four speeds times 1.2, 1, 1, 1.1, three seeds of each: mean 0.3120,
# standard error 0.2902 sqrt(0.0825 / 11 / 12)
expect "| 2 | 0.312 ± 0.007 |"
# over the others between 0.5 and 2 m/s: 1.2 / (3.1 / 3), 1 / (2.1 / 2), 1.1 / 1
expect "| 0.1 | 90 | 1.161 ± 0.000 | 1.161 ± 0.000 | 1.161 ± 0.000 | 1.000 ± 0.000 |"
expect "| 0.5 | 90 | 0.952 ± 0.000 |"
expect "| 2 | 90 | 1.100 ± 0.000 |"
expect "| 5 | 15 | 0.917 ± 0.000 | 0.917 ± 0.000 | 0.917 ± 0.000 | 1.000 ± 0.000 | 1.300 ± 0.000 |"  # 1.1 / 1.2, 130 / 100
expect "| 5 | 60 | 20.0 ± 0.0 | 20 | 0 | 1.10 ± 0.00 |"  # 22 depths, 20 chips

# A case of three seeds scatters by 0.1 / sqrt(3). Over 120 cases the ratio of forces, 0.56 in the mean square, then gives
# psi to 0.13 degrees, and the logarithm of depth, whose standard deviation is 0.8, gives n to 0.007; three of these are
# allowed, for psi rather more.
make_up 0.4 0.4 0.1 >"$folder/scattered.csv"
"$trends" "$folder/scattered.csv" >"$folder/out"
expect_near 'psi = ' 7.5 0.6
expect_near 'psi = [0-9.]* ± ' 0.13 0.03
expect_near ' cases: n = ' 0.4 0.021

# A force that rubs, 4 kN/m in all cuts, is told from psi.
make_up 0.4 0.4 0 | awk -F, 'BEGIN { OFS = "," } NR > 1 { $9 = sprintf("%.17g", $9 + 4000) } { print }' >"$folder/rubbing.csv"
"$trends" "$folder/rubbing.csv" >"$folder/out"
expect "psi = 7.50 degrees, f = 4.00 kN/m, R2 = 1.000"

make_up size size 0 >"$folder/size.csv"
"$trends" "$folder/size.csv" >"$folder/out"
expect "d0 = 0.80 mm"
expect "it leaves 0.0 % from case to case"

# A break is seen for what it is, and not seen where there is none.
make_up 0.1 0.6 0.1 >"$folder/broken.csv"
"$trends" "$folder/broken.csv" >"$folder/out"
expect "Best break at 2 mm"
expect_near 'Best break at 2 mm: n = ' 0.1 0.04
expect_near '; F = ' 200 150  # 120 cases of 6 % scatter against a bend of up to 0.2

if echo 'case,seed' | cat - >"$folder/bad.csv" && "$trends" "$folder/bad.csv" >"$folder/out" 2>&1; then
  fail "a table without forces was accepted"
fi
grep -q 'bad.csv: column cutter_speed_m_per_s is missing' "$folder/out" || fail "the message about a missing column"
if "$trends" "$folder/none.csv" >"$folder/out" 2>&1; then fail "a file that is not there was accepted"; fi
