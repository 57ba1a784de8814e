#!/usr/bin/python3
"""Peaks of my own force record, what the networks say of such a cut, and the force on a bit inside a loop of mine.

    PYTHONPATH=build/release/python /usr/bin/python3 examples/own_force.py
"""

# %% Peaks of a record: any array of forces at even spacing, here made up
import numpy as np

import bitrock

samples = np.random.default_rng(1).gamma(2.0, 15e3, size=5000)  # [N/m]
found = bitrock.peaks.statistics(samples)
print(f"my record: highest peak {found.amax:.3g} N/m, mean {found.amean:.3g} N/m, {found.count} peaks")

# %% What the networks say of cuts 1 to 3 mm deep at 0.5 m/s and 15 degrees of back rake
model = bitrock.Model.load("campaigns/paper240/model.json")
depth_mm = np.array([1.0, 2.0, 3.0])
said = model.predict(speed_m_per_s=0.5, depth_mm=depth_mm, rake_deg=15)
for depth, amax, inside in zip(depth_mm, said["x_amax_N_per_m"], said["inside_training_range"]):
    print(f"{depth:.0f} mm deep: highest peak {amax / 1e3:.0f} kN/m" + ("" if inside else " (extrapolated)"))

# %% The bit in a loop: here a mass that the weight on bit pushes into the rock, against a damper
bit = bitrock.Bit.load("campaigns/bits/pdc15.toml")
force = bitrock.BitForce(bit, model)
step_s, mass_kg, damping_N_s_per_m, weight_N = 1e-4, 2000.0, 2e6, 25e3
rotation_rad_per_s = 60 * 2 * np.pi / 60  # 60 rpm
angle_rad, speed_m_per_s, depth_m, torque_N_m = 0.0, 10 / 3600, 0.0, []
for _ in range(20_000):
    push_N, torque = force.at(angle_rad, rotation_rad_per_s, max(speed_m_per_s, 0.0))
    speed_m_per_s += step_s / mass_kg * (weight_N - push_N - damping_N_s_per_m * speed_m_per_s)
    depth_m += step_s * speed_m_per_s
    angle_rad += step_s * rotation_rad_per_s
    torque_N_m.append(torque)
print(f"2 s on {bit.name}: {1e3 * depth_m:.2f} mm drilled, mean torque {np.mean(torque_N_m):.0f} N m")
print(f"questions to the networks: {force.clamps}")
