#!/usr/bin/python3
"""How true networks are, against cuts that nobody learnt from: truth.py BITROCK MODEL.json TRUTH.csv [MODEL.json TRUTH.csv ...]

TRUTH.csv is the table of campaigns/truth.toml (12 conditions off the grid, 16 rocks each), counted as the networks have learnt to count
(`campaign collect`, or `campaign features` with another definition). Printed is a table for docs/results/learning.md: for each output the
networks' own root mean square error with the scatter of the truth taken out, the upper end of its 95 % interval, and their bias, all as
shares of what they say; and whether the bars are kept: error below 8 % and bias below 4 % of amplitudes and mean forces, error below 12 % of
the counts of middle and high peaks.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

FORCES = [f"{axis}_{name}_N_per_m" for axis in "xy" for name in ("amax", "amean", "mean")]
COUNTS = [f"{axis}_{name}_per_m" for axis in "xy" for name in ("np1", "np23", "np4")]


def bar_of(name):
    """Of error and bias; None where there is none."""
    if name in FORCES:
        return 0.08, 0.04
    return (None, None) if "np1" in name else (0.12, None)


def main():
    program, pairs = sys.argv[1], sys.argv[2:]
    if not pairs or len(pairs) % 2:
        sys.exit(__doc__)
    print("| networks | output | own error, % (at most) | bias, % (by chance) | bars |")
    print("|---|---|---|---|---|")
    for model, truth in zip(pairs[::2], pairs[1::2]):
        with tempfile.TemporaryDirectory() as folder:
            result = Path(folder) / "parity.json"
            subprocess.run([program, "parity", model, truth, "--unseen", "--quiet", "--json", result], check=True)
            outputs = json.loads(result.read_text())["outputs"]
        for name in FORCES + COUNTS:
            if name not in outputs:
                continue
            error = outputs[name]["network_error"]
            if error is None:
                print(f"| {model} | {name} | not known | | |")
                continue
            most, most_bias = bar_of(name)
            kept = (most is None or error["rms"] < most) and (most_bias is None or abs(error["bias"]) < most_bias)
            print(f"| {model} | {name} | {100 * error['rms']:.1f} ({100 * error['rms_high']:.1f}) | "
                  f"{100 * error['bias']:+.1f} ({100 * error['bias_chance']:.1f}) | "
                  f"{'-' if most is None else 'kept' if kept else 'missed'} |")


if __name__ == "__main__":
    main()
