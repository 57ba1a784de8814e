#!/usr/bin/python3
"""The table of docs/results/peaks.md, of run files sampled every 5 um (peak_sampling.sh)."""
import collections
import sys

import numpy as np

import bitrock
from bitrock import peaks

GRAIN, FINEST = 0.5e-3, 5e-6
SAMPLINGS = (5, 10, 20, 40)  # [um]


def block_means(force, each):
    return force[: len(force) // each * each].reshape(-1, each).mean(axis=1)


def numbers(force, micrometres, converging):
    samples = block_means(force, micrometres // 5)
    asked = {"smoothing": 0.08 * GRAIN / (micrometres * 1e-6), "min_prominence": 0.02} if converging else {}
    s = peaks.statistics(samples, **asked)
    return np.array([s.amax, s.amean, s.np1, s.np23, s.np4, s.count], dtype=float)


groups = collections.defaultdict(list)
for path in sys.argv[1:]:
    run = bitrock.read_run(path)
    depth_mm = round(run.mean_force_x_N_per_m / run.specific_energy_Pa * 1e3, 6)
    speed = round(run.cut_length_m / run.duration_s, 6)
    groups[depth_mm, speed].append(run)

print("| depth [mm] | speed [m/s] | force | definition | peaks per metre at 5, 10, 20, 40 um | over that at 10 um: "
      "peaks | A_mean | A_max |")
print("|---|---|---|---|---|---|---|---|")
pooled = collections.defaultdict(lambda: np.zeros((len(SAMPLINGS), 6)))
for (depth, speed), runs in sorted(groups.items()):
    for axis in "xy":
        for definition in ("article", "converging"):
            seen = np.array([
                sum(numbers(getattr(run, f"force_{axis}_N_per_m"), u, definition == "converging") for run in runs)
                for u in SAMPLINGS
            ])
            pooled[definition] += seen / seen[1]
            length = sum(run.cut_length_m for run in runs)
            counts = ", ".join(f"{count / length:.0f}" for count in seen[:, 5])
            ratio = seen / seen[1]
            columns = " | ".join(" ".join(f"{r:.3f}" for r in ratio[:, k]) for k in (5, 1, 0))
            print(f"| {depth:g} | {speed:g} | {axis} | {definition} | {counts} | {columns} |")
for definition, total in pooled.items():
    ratio = total / total[1]
    columns = " | ".join(" ".join(f"{r:.3f}" for r in ratio[:, k]) for k in (5, 1, 0))
    print(f"| all | | | {definition} | | {columns} |")
