#!/usr/bin/env bash
# The string of the article's deviated well under the networks, under a sinusoid of equal mean and RMS and without excitation
# (docs/results/well.md): ten seeds with bars of 10 m, three with bars of 2 m in the lowest 100 m. Writes runs, tables and the figures
# of one seed into FOLDER and Markdown to the standard output; some ten minutes of one core.
#   tests/validation/well_sources.sh FOLDER        B: the program
set -euo pipefail
B=${B:-build/release/cli/bitrock}
out=${1:?usage: well_sources.sh FOLDER}
mkdir -p "$out"
case=campaigns/drill/deviated.toml
# the lowest half of the collars in bars of 2 m, sampled for what these pass
awk -v campaigns="$PWD/campaigns" '
  /^length_m = 200$/ { collars = 1; sub(/200/, "100") }
  { gsub(/\.\.\//, campaigns "/"); sub(/^step_ms = 0.5$/, "step_ms = 0.19"); sub(/^sample_ms = 1$/, "sample_ms = 0.5") }
  collars && /^segment_length_m = 10$/ {
    print
    print "\n[[pipe]]\nlength_m = 100\nouter_diameter_mm = 165.1\ninner_diameter_mm = 71.4375\nsegment_length_m = 2"
    collars = 0
    next
  }
  { print }' "$case" >"$out/fine.toml"
grep -q '^segment_length_m = 2$' "$out/fine.toml" || { echo "well_sources: $case has other collars than this script knows" >&2; exit 2; }
"$B" drill compare "$case" --seeds 1:10 -o "$out/bars_10_m" --quiet
"$B" drill compare "$out/fine.toml" --seeds 1:3 -o "$out/bars_2_m" --quiet
"$B" report "$out"/bars_10_m/{networks_1,sinusoidal_1,none}.h5 -o "$out/report.html" --figures "$out/figures" --quiet
shown='^\| point \||^\|---|sd, |damage an hour'
for bars in "10 m" "2 m"; do
  printf '### Bars of %s\n\n' "$([ "$bars" = "2 m" ] && echo "2 m in the lowest 100 m, three seeds" || echo "10 m, ten seeds")"
  grep -E "$shown" "$out/bars_${bars/ /_}/summary.md"
  echo
done
