#!/usr/bin/python3
"""The shipped networks against the shipped cuts: what the DEM says, what the networks say, and the scatter of the DEM.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/parity.py parity.png

Cells begin with `# %%`: Jupyter, Spyder and VS Code run them one by one.
"""

# %% Networks and cuts
import sys

import matplotlib.pyplot as plt
import numpy as np

import bitrock

model = bitrock.Model.load("campaigns/paper240/model.json")
parity = bitrock.parity(model, "campaigns/paper240/features.csv")
print(model)

# %% How far off, on cases that the networks have not learnt from
print(f"{'output':<18}{'cases':>6}{'mean deviation':>16}{'from scatter alone':>20}{'RMSE / s.e.':>13}")
for name, output in parity.outputs.items():
    held = output.held_out
    print(
        f"{name:<18}{held['cases']:>6}{held['mean_deviation']:>15.1%} {held['noise_alone']['mean']:>18.1%} "
        f"{held['rmse_over_standard_error']:>12.2f}"
    )

# %% The plot
SHOWN = {
    "x_amax_N_per_m": ("highest peak [kN/m]", 1e-3),
    "x_amean_N_per_m": ("mean peak [kN/m]", 1e-3),
    "x_np4_per_m": ("low peaks per mm of cut", 1e-3),
}
figure, panels = plt.subplots(2, 3, figsize=(11, 7.4), layout="constrained")
for row, axis in enumerate("xy"):
    for panel, (name, (label, factor)) in zip(panels[row], SHOWN.items()):
        output = parity.outputs[axis + name[1:]]
        dem, network = factor * output.dem_mean, factor * output.prediction
        error = factor * output.dem_standard_error
        held_out = np.isin(output.role, ["test", "unseen"])
        for group, colour, what in [(~held_out, "0.65", "learnt from"), (held_out, "C3", "held out")]:
            panel.errorbar(
                dem[group], network[group], xerr=error[group],
                fmt="o", ms=3.5, lw=0.7, color=colour, label=f"{what} ({group.sum()})", zorder=2 + (colour == "C3"),
            )  # fmt: skip
        end = 1.05 * max(dem.max(), network.max())
        panel.plot([0, end], [0, end], color="k", lw=0.8, zorder=1)
        panel.set(xlim=(0, end), ylim=(0, end), aspect="equal", xlabel=f"DEM: {label}", ylabel="networks")
        direction = {"x": "along the cut", "y": "out of the rock"}[axis]
        panel.set_title(f"{direction}: R² {output.held_out['r2']:.2f} on cases held out", fontsize=10)
panels[0, 0].legend(loc="upper left", fontsize=9)
figure.suptitle("Peaks of the force on one cutter: networks against DEM (bars: standard error of the DEM)")

# %%
picture = sys.argv[1] if len(sys.argv) > 1 else "parity.png"
figure.savefig(picture, dpi=120)
print("->", picture)
