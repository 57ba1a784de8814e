#!/usr/bin/env bash
# What raises the strength of the article's rock under pressure (docs/results/mud.md): friction angle of the bonded joints,
# friction of broken ones, cohesion. Cores of 30 x 60 mm, three seeds; some two minutes of two cores.
#   tests/validation/confined.sh [FOLDER] | tests/validation/into_page.sh confined docs/results/mud.md
#                     B: the program, JOBS: tests at a time, SEEDS: e.g. 1:3
set -euo pipefail
B=${B:-build/release/cli/bitrock}
JOBS=${JOBS:-$(nproc)}
SEEDS=${SEEDS:-1:3}
out=${1:-try/confined}
mkdir -p "$out"

echo "| changed | strength without pressure, MPa | along the load under 20 MPa, MPa | ratio |"
echo "|---|---|---|---|"
vary() { # name, sed expression
  sed -e "$2" campaigns/rocks/article.toml >"$out/rock.toml"
  "$B" lab triaxial "$out/rock.toml" --confining-pressures-MPa 0,20 --width-mm 30 --height-mm 60 --seeds "$SEEDS" \
    --jobs "$JOBS" --quiet --json "$out/one.json" 2>/dev/null
  /usr/bin/python3 - "$1" "$out/one.json" <<'END'
import json, sys
rows = json.load(open(sys.argv[2]))["by_pressure"]
free, confined = [(row["confining_pressure_Pa"] + row["mean"]["peak_stress_Pa"], row["sd"]["peak_stress_Pa"]) for row in rows]
print("| %s | %.1f +- %.1f | %.1f +- %.1f | %.2f |" % (
    sys.argv[1], free[0] / 1e6, free[1] / 1e6, confined[0] / 1e6, confined[1] / 1e6, confined[0] / free[0]))
END
}
key() { echo "s/^$1 = .*/$1 = $2/"; }
vary "nothing: friction angle 0, friction 0.577, cohesion 58.2 MPa" ""
vary "friction 0.3" "$(key friction_coefficient 0.3)"
vary "friction 1" "$(key friction_coefficient 1)"
vary "friction angle 30 degrees" "$(key friction_angle_deg 30)"
vary "friction angle 60 degrees" "$(key friction_angle_deg 60)"
vary "friction angle 60 degrees, cohesion 30 MPa" "$(key friction_angle_deg 60); $(key cohesion_MPa 30)"
