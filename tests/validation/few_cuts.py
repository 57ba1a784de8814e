#!/usr/bin/python3
"""How much networks learn from few cuts, with and without a formula as teacher: few_cuts.py BITROCK FEATURES.csv [REPEATS]

A quarter of the cases of FEATURES.csv is set aside. From the others so many single cuts are drawn, each of another case, or all are
taken; networks are trained on them with --from-cases, and as `bitrock train` does by itself, and held against the cases set aside. Printed is a table
for docs/results/learning.md: the error on these cases in standard errors of their means (1: a faultless model), the root mean square
over the ten outputs, and what of it is the networks' own, as a share of A_max and A_mean.
"""
import csv
import json
import math
import random
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

OUTPUTS = [f"{axis}_{name}" for axis in "xy" for name in ("amax_N_per_m", "amean_N_per_m", "np1_per_m", "np23_per_m", "np4_per_m")]


def errors(program, folder, train, aside, flags):
    model, result = folder / "model.json", folder / "parity.json"
    subprocess.run([program, "train", train, "-o", model, "--split", "0.999", "--quiet", *flags], check=True)
    subprocess.run([program, "parity", model, aside, "--unseen", "--quiet", "--json", result], check=True)
    outputs = json.loads(result.read_text())["outputs"]
    ratios = [outputs[name]["held_out"]["rmse_over_standard_error"] for name in OUTPUTS]
    own = {name: max(outputs[name]["held_out"]["rmse"] ** 2 - outputs[name]["held_out"]["dem_standard_error_by_law"] ** 2, 0.0)
           for name in OUTPUTS}
    return math.sqrt(statistics.mean(ratio**2 for ratio in ratios)), own


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, features = sys.argv[1:3]
    repeats = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    with open(features, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    cases = sorted({row["case"] for row in rows}, key=int)
    random.Random(1).shuffle(cases)
    quarter = len(cases) // 4
    set_aside, pool = set(cases[:quarter]), cases[quarter:]
    means = {name: statistics.mean(float(row[name]) for row in rows if row["case"] in set_aside)
             for name in ("x_amax_N_per_m", "y_amax_N_per_m", "x_amean_N_per_m", "y_amean_N_per_m")}

    def write(path, kept):
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, fieldnames=rows[0].keys())
            writer.writeheader()
            writer.writerows(kept)

    print("| cuts | from | error on unseen cases, standard errors | own error, % of the mean: A_max x, y | A_mean x, y |")
    print("|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write(folder / "aside.csv", [row for row in rows if row["case"] in set_aside])
        for count in (30, 60, 120, len(pool), 0):
            for words, flags in (("cases", ["--from-cases"]), ("a formula", [])):
                found = []
                for repeat in range(repeats if count else 1):
                    draw = random.Random(100 * count + repeat)
                    if count:
                        kept = [draw.choice([row for row in rows if row["case"] == case]) for case in draw.sample(pool, count)]
                    else:
                        kept = [row for row in rows if row["case"] not in set_aside]
                    write(folder / "train.csv", kept)
                    found.append(errors(program, folder, folder / "train.csv", folder / "aside.csv", flags))
                ratios = [one[0] for one in found]
                spread = f" +- {statistics.stdev(ratios) / math.sqrt(len(ratios)):.2f}" if len(ratios) > 1 else ""
                own = {key: 100.0 * math.sqrt(statistics.mean(one[1][key] for one in found)) / means[key] for key in means}
                print(f"| {count or len(kept)} | {words} | {statistics.mean(ratios):.2f}{spread} | {own['x_amax_N_per_m']:.1f}, "
                      f"{own['y_amax_N_per_m']:.1f} | {own['x_amean_N_per_m']:.1f}, {own['y_amean_N_per_m']:.1f} |", flush=True)


if __name__ == "__main__":
    main()
