#!/usr/bin/python3
"""Torque and force of a whole bit against the sum of the DEM's means: python3 tests/validation/bit_torque.py BITROCK MODEL FEATURES_MEAN BIT

For speeds and depths of cut: `bitrock signal` over 200 turns beside sum F_x w r and sum F_y w over the cutters, F the means of
the cuts (FEATURES_MEAN, one row a case of a full grid), linear between their speeds, depths and rakes, at the nearest edge outside.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import numpy as np

RPM = (60.0, 90.0, 120.0, 180.0)
DEPTHS_MM = (0.5, 1.0, 2.0, 3.0, 4.0, 5.0)
TURNS = 200.0


class Means:
    """x_mean, y_mean [N/m] over speed [m/s], depth [mm], rake [deg]."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        names = ("cutter_speed_m_per_s", "depth_of_cut_mm", "back_rake_deg")
        self.axes = [sorted({float(row[name]) for row in rows}) for name in names]
        self.values = np.full((2, *map(len, self.axes)), np.nan)
        for row in rows:
            place = tuple(axis.index(float(row[name])) for axis, name in zip(self.axes, names))
            for component, column in enumerate(("x_mean_N_per_m", "y_mean_N_per_m")):
                self.values[(component, *place)] = float(row[column])
        if np.isnan(self.values).any():
            sys.exit(f"{path}: the cases are no full grid")

    def at(self, *where):
        values = self.values
        for axis, value in zip(self.axes, where):
            value = min(max(value, axis[0]), axis[-1])
            i = min(max(int(np.searchsorted(axis, value)) - 1, 0), max(len(axis) - 2, 0))
            if len(axis) == 1:
                values = values[:, 0]
                continue
            part = (value - axis[i]) / (axis[i + 1] - axis[i])
            values = (1.0 - part) * values[:, i] + part * values[:, i + 1]
        return values


def expected(bit, means, rpm, depth_mm):
    torque = force = 0.0
    for cutter in bit["cutter"]:
        radius, width = 1e-3 * cutter["radius_mm"], 1e-3 * cutter["width_mm"]
        x, y = means.at(rpm * 2.0 * np.pi / 60.0 * radius, depth_mm, cutter["back_rake_deg"])
        torque += x * width * radius
        force += y * width
    return torque, force


def main(bitrock, model, table, bit_file):
    bit, means = tomllib.loads(pathlib.Path(bit_file).read_text(encoding="utf-8")), Means(table)
    print("| rpm | depth of cut [mm] | ROP [m/h] | torque, DEM [N m] | rebuilt | off [%] | force, DEM [N] | rebuilt | off [%] |")
    print("|---|---|---|---|---|---|---|---|---|")
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for rpm in RPM:
            for depth in DEPTHS_MM:
                rop = 60e-3 * depth * rpm
                seconds = 60.0 * TURNS / rpm
                subprocess.run([bitrock, "signal", bit_file, "--model", model, "--rpm", f"{rpm}", "--rop-m-per-h", f"{rop:.10g}",
                                "--duration-s", f"{seconds}", "--rate-hz", "2000", "-o", f"{folder}/s.csv", "--json",
                                f"{folder}/s.json", "--quiet"], check=True, stderr=subprocess.DEVNULL)
                seen = json.loads(pathlib.Path(folder, "s.json").read_text(encoding="utf-8"))
                torque, force = expected(bit, means, rpm, depth)
                off = [100.0 * (seen["mean_torque_N_m"] / torque - 1.0), 100.0 * (seen["mean_force_N"] / force - 1.0)]
                worst = max(worst, abs(off[0]))
                print(f"| {rpm:g} | {depth:g} | {rop:.3g} | {torque:.0f} | {seen['mean_torque_N_m']:.0f} | {off[0]:+.1f} | "
                      f"{force:.0f} | {seen['mean_force_N']:.0f} | {off[1]:+.1f} |")
    print(f"\nworst torque: {worst:.1f} % (asked: 5 %)")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
