#!/usr/bin/python3
"""The tables of docs/results/rebuild.md, of what `bitrock rebuild --json` wrote (rebuild.sh): python3 tests/validation/rebuild.py REBUILD.json"""
import collections
import json
import math
import sys

WORDS = {"own": "the cuts", "model": "the networks"}


def root_mean_square(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def shown(value, unit, signed=False):
    digits = 3 if unit == "1" else 1
    return f"{value:{'+' if signed else ''}.{digits}f}"


def bars(found):
    print("| statistics of | mode | number | of | unit | rms | worst | asked | within it [%] | asked [%] | |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for one in found["summary"]:
        of = {"x": "F_x", "y": "F_y", "b": "both"}[one["component"]]
        reached = one["share_within_bar"] >= one["share_asked"]
        verdict = "our measure" if one["measure"] == "correlation length" else "reached" if reached else "**not reached**"
        print(f"| {WORDS[one['statistics']]} | {one['mode']} | {one['measure']} | {of} | {one['unit']} | {shown(one['rms'], one['unit'])} | "
              f"{shown(one['worst'], one['unit'], True)} | {one['bar']:g} | {100 * one['share_within_bar']:.1f} of {one['count']} | "
              f"{100 * one['share_asked']:g} | {verdict} |")


def by_depth(found):
    groups = collections.defaultdict(list)
    for one in found["comparisons"]:
        groups[(one["statistics"], one["mode"], round(1e3 * one["depth_of_cut_m"], 6))].append(one)
    print("| statistics of | mode | depth [mm] | cases | mean, F_x and F_y [%] | sd [%] | damage range [%] | octaves above 3 dB [%] | "
          "without force: DEM, rebuilt [%] | mean stretch without: DEM, rebuilt [mm] | A_max over DEM's | peaks in quarters: DEM, rebuilt |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for (statistics, mode, depth), cases in sorted(groups.items(), key=lambda item: (item[0][0] != "own", item[0][1] != "sawtooth", item[0])):
        def off(key):
            pair = [root_mean_square([100 * (case[c][key] - 1) for case in cases]) for c in "xy"]
            return f"{pair[0]:.1f}, {pair[1]:.1f}"

        def mean(key):
            return sum(case["x"][key] for case in cases) / len(cases)

        octaves = [abs(value) > 3 for case in cases for c in "xy" for value in case[c]["octave_difference_dB"]]
        amax = sum(case["x"]["peaks"]["amax"] / case["x"]["peaks_dem"]["amax"] for case in cases) / len(cases)
        print(f"| {WORDS[statistics]} | {mode} | {depth:g} | {len(cases)} | {off('mean_ratio')} | {off('sd_ratio')} | {off('damage_range_ratio')} | "
              f"{100 * sum(octaves) / len(octaves):.0f} | {100 * mean('zero_force_share_dem'):.0f}, {100 * mean('zero_force_share'):.0f} | "
              f"{1e3 * mean('zero_force_period_dem_m'):.2f}, {1e3 * mean('zero_force_period_m'):.2f} | {amax:.2f} | "
              f"{mean('quarter_dispersion_dem'):.2f}, {mean('quarter_dispersion'):.2f} |")


def main(path):
    with open(path, encoding="utf-8") as file:
        found = json.load(file)
    cases = {(one["file"], one["case"]) for one in found["comparisons"]}
    print(f"{len(cases)} cases; {found['draws']} pieces of the length of the cut rebuilt of each.\n")
    bars(found)
    print("\nBy depth of cut, root mean squares over the cases; the last four columns are means, of F_x.\n")
    by_depth(found)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
