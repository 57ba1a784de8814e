#!/usr/bin/env bash
# What decides the ratio of compressive to tensile strength (docs/results/validation.md): one change of campaigns/rocks/start.toml
# at a time, four specimens each. Run from the root of the repository; about five minutes on two cores.
#   tests/validation/strength_ratio.sh [FOLDER]
set -euo pipefail
B=${B:-build/release/cli/bitrock}
start=campaigns/rocks/start.toml
out=${1:-try/ratio}
mkdir -p $out
vary() { # name, sed expression
  sed -e 's/cohesion_MPa = 50/cohesion_MPa = 150/; s/cohesion_deviation_MPa = 12.5/cohesion_deviation_MPa = 37.5/; s/stiffness_ratio = 2.5/stiffness_ratio = 3.5/' -e "$2" $start > $out/$1.toml
  $B lab ucs $out/$1.toml --seeds 1,2,3,4 --quiet --json $out/$1_ucs.json ${3:-}
  $B lab tension $out/$1.toml --seeds 1,2,3,4 --quiet --json $out/$1_tension.json ${3:-}
  /usr/bin/python3 - $out/$1 <<'P'
import json, sys
ucs, pull = (json.load(open(f'{sys.argv[1]}_{t}.json'))['mean'] for t in ('ucs', 'tension'))
print(f"| {sys.argv[1].split('/')[-1]} | {ucs['peak_stress_Pa']/1e6:.1f} | {pull['peak_stress_Pa']/1e6:.2f} | {ucs['peak_stress_Pa']/pull['peak_stress_Pa']:.1f} | {pull['youngs_modulus_Pa']/1e9:.2f} | {pull['poissons_ratio']:.3f} |", flush=True)
P
}
vary reference 's/x/x/'
vary cohesion_50 's/cohesion_MPa = 150/cohesion_MPa = 50/; s/cohesion_deviation_MPa = 37.5/cohesion_deviation_MPa = 12.5/'
vary cohesion_400 's/cohesion_MPa = 150/cohesion_MPa = 400/; s/cohesion_deviation_MPa = 37.5/cohesion_deviation_MPa = 100/'
vary no_scatter 's/deviation_MPa = .*/deviation_MPa = 0/'
vary scatter_half 's/tensile_strength_deviation_MPa = 2.5/tensile_strength_deviation_MPa = 5/; s/cohesion_deviation_MPa = 37.5/cohesion_deviation_MPa = 75/'
vary pressure_30 's/pressure_MPa = 60/pressure_MPa = 30/'
vary pressure_10 's/pressure_MPa = 60/pressure_MPa = 10/'
vary elements_1 's/elements = 2/elements = 1/'
vary elements_4 's/elements = 2/elements = 4/'
vary kappa_2 's/stiffness_ratio = 3.5/stiffness_ratio = 2/'
vary friction_1.2 's/friction_coefficient = 0.577/friction_coefficient = 1.2/'
vary damping_0.7 's/x/x/' '--local-damping 0.7'
vary slit_20 's/elements = 2/elements = 2\nslit_fraction = 0.2/'
