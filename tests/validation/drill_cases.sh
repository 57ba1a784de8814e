#!/usr/bin/env bash
# The three cases of the drill string (docs/results/validation.md): under the networks, a sine and white noise of equal mean and
# RMS over ten seeds; what each assumption decides; the map of the stick-slip string. Writes runs, tables and the map into
# FOLDER and Markdown to the standard output; some minutes of one core.
#   tests/validation/drill_cases.sh FOLDER MODEL.json        B: the program
set -euo pipefail
B=${B:-build/release/cli/bitrock}
out=${1:?usage: drill_cases.sh FOLDER MODEL.json}
model=${2:?usage: drill_cases.sh FOLDER MODEL.json}
mkdir -p "$out"
declare -A heading=([normal]="Normal drilling: 25 kN, 60 rpm" [stick_slip]="Stick-slip: 15 kN, 30 rpm"
  [bit_bounce]="Bit bounce: 35.5 kN, 60 rpm")
for case in normal stick_slip bit_bounce; do
  "$B" drill compare "campaigns/drill/$case.toml" --model "$model" --seeds 1:10 -o "$out/$case" --quiet
  printf '### %s\n\n' "${heading[$case]}"
  cat "$out/$case/summary.md"
  echo
done
/usr/bin/python3 - "$B" "$out" "$model" <<'PY'
import csv
import json
import os
import re
import subprocess
import sys

program, out, model = sys.argv[1:]
cases = {"normal": (25, 60, "steady"), "stick_slip": (15, 30, "stick_slip"), "bit_bounce": (35.5, 60, "bit_bounce")}
seeds = 3
bits = os.path.abspath("campaigns/bits/pdc15.toml")


def bit_with(share):
    """The shipped bit with cutters that cut `share` of their width: that share of force and torque."""
    path = f"{out}/bit_{share}.toml"
    text = re.sub(r"^width_mm = (\S+)", lambda found: f"width_mm = {float(found[1]) * share:.6g}", open(bits).read(),
                  flags=re.M)
    open(path, "w").write(text)
    return os.path.abspath(path)


variants = [
    ("as shipped", {}),
    ("damping of the torsional pairs 1 %", {"torsional_damping_ratio": 0.01}),
    ("the same 4 %", {"torsional_damping_ratio": 0.04}),
    ("the same 6 %", {"torsional_damping_ratio": 0.06}),
    ("damping of the axial pairs 0.5 %", {"axial_damping_ratio": 0.005}),
    ("the same 10 %", {"axial_damping_ratio": 0.1}),
    ("mu0 0.03", {"mu0": 0.03}),
    ("mu0 0.12", {"mu0": 0.12}),
    ("hump alpha 2, beta 1, nu 0.01 (recalled)", {"alpha_s": 2, "beta": 1, "nu_s": 0.01}),
    ("arm of the friction: radius of the bit", {"friction_radius_mm": 107.95}),
    ("pipe 27.5 kg/m", {"linear_mass_kg_per_m": 27.5}),
    ("pipe 28.2 kg/m", {"linear_mass_kg_per_m": 28.2}),
    ("pipe 29.02 kg/m, with tool joints", {"linear_mass_kg_per_m": 29.02}),
    ("C1 half", {"c1_m_per_s_per_N_per_sqrt_rad_per_s": 0.675e-8}),
    ("C1 double", {"c1_m_per_s_per_N_per_sqrt_rad_per_s": 2.7e-8}),
    ("rock ten times softer", {"stiffness_N_per_m": 1.16e8}),
    ("rock damped ten times less", {"damping_N_s_per_m": 1.5e4}),
    ("stiffness before the cutters 5e3 N m/rad", {"fracture_stiffness_N_m_per_rad": 5e3}),
    ("the same 1e5 N m/rad", {"fracture_stiffness_N_m_per_rad": 1e5}),
    ("that spring gives back (elastic)", {"unloading": '"elastic"'}),
    ("axial force without its mean", {"axial_source": '"fluctuation"'}),
    ("no axial force", {"axial_source": '"none"'}),
    ("cutters out of the rock at 0.2 mm", {"engagement_depth_mm": 0.2}),
    ("the same at 1 mm", {"engagement_depth_mm": 1}),
    ("half the force and torque of the networks", {"file": f'"{bit_with(0.5)}"'}),
    ("a fifth of them", {"file": f'"{bit_with(0.2)}"'}),
    ("double of them", {"file": f'"{bit_with(2.0)}"'}),
    ("four lumps each way", {"axial_lumps": 4, "torsional_lumps": 4}),
    ("half the step, 0.05 ms", {"step_ms": 0.05}),
]


def changed(text, changes):
    text = text.replace('"../bits/pdc15.toml"', f'"{bits}"')
    for key, value in changes.items():
        line = f"{key} = {value}"
        text, found = re.subn(rf"^{key} = .*$", lambda _: line, text, flags=re.M)
        section = {"friction_radius_mm": "bit", "linear_mass_kg_per_m": "[pipe]", "waves_per_turn": "excitation",
                   "piece_deg": "excitation"}.get(key)
        if not found:
            text = text.replace(f"[{section}]\n", f"[{section}]\n{line}\n")
        assert line in text, key
    return text


print(f"### What decides\n\nRuns that are what their case is called, of {seeds}; in brackets mean severity, or the "
      "greatest WOB over the static one and the share of time off bottom.\n")
print("| | normal: steady | stick-slip | bit bounce |\n|---|---|---|---|")
for name, changes in variants:
    cells = []
    for case, (hook, rotation, wanted) in cases.items():
        path = f"{out}/sensitivity"
        open(path + ".toml", "w").write(changed(open(f"campaigns/drill/{case}.toml").read(), changes))
        done = subprocess.run([program, "drill", "map", path + ".toml", "--model", model, "--hook-load-kN", str(hook),
                               "--rotation-rpm", str(rotation), "--seeds", f"1:{seeds}", "-o", path + ".csv", "--json",
                               path + ".json", "--quiet"], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{name}, {case}: {done.stderr}")
        count = json.load(open(path + ".json"))
        rows = [row for row in csv.DictReader(open(path + ".csv")) if row["status"] == "ok"]
        mean = lambda column: sum(float(row[column]) for row in rows) / len(rows)
        if not rows:
            cells.append("failed")
        elif wanted == "bit_bounce":
            peak = mean("weight_on_bit_max_kN") / mean("static_weight_on_bit_kN")
            cells.append(f"{count[wanted]} ({peak:.1f}, {100 * mean('share_off_bottom'):.2g} %)")
        else:
            cells.append(f"{count[wanted]} ({mean('severity'):.2f})")
    print(f"| {name} | " + " | ".join(cells) + " |", flush=True)

print(f"\n### Bit bounce by other sines and noises\n\nOf the mean and RMS of the networks; {seeds} seeds. Sine: waves a turn, "
      "at 60 rpm the same number in Hz. Noise: angle of one draw; white up to the frequency beside it.\n")
print("| source | runs with bit bounce | greatest WOB [kN] | time off bottom [%] |\n|---|---|---|---|")
for source, key, value, name in [
        ("networks", "piece_deg", 0.573, "networks"), ("sinusoidal", "waves_per_turn", 1, "sine, 1"),
        ("sinusoidal", "waves_per_turn", 11, "sine, 11"), ("sinusoidal", "waves_per_turn", 60, "sine, 60"),
        ("sinusoidal", "waves_per_turn", 120, "sine, 120"), ("noise", "piece_deg", 0.573, "noise, 0.57 deg, 310 Hz"),
        ("noise", "piece_deg", 2, "noise, 2 deg, 90 Hz"), ("noise", "piece_deg", 6, "noise, 6 deg, 30 Hz")]:
    path = f"{out}/other"
    open(path + ".toml", "w").write(changed(open("campaigns/drill/bit_bounce.toml").read(), {key: value}))
    subprocess.run([program, "drill", "compare", path + ".toml", "--model", model, "--seeds", f"1:{seeds}", "-o", path,
                    "--quiet"], check=True)
    rows = [row for row in csv.DictReader(open(path + "/summary.csv")) if row["source"] == source]
    mean = lambda column: sum(float(row[column]) for row in rows) / len(rows)
    print(f"| {name} | {sum(int(row['bit_bounce']) for row in rows)} | {mean('weight_on_bit_max_kN'):.1f} | "
          f"{mean('off_bottom_percent'):.2g} |", flush=True)
PY
"$B" drill map campaigns/drill/stick_slip.toml --model "$model" --hook-load-kN 4:38:18 --rotation-rpm 20:140:21 \
  -o "$out/map.csv" --picture "$out/stick_slip_map.png" >&2
