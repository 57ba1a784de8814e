import copy
import csv
import math
import tomllib

import numpy as np
import pytest
from conftest import BIT, MODEL

import bitrock

ROTATION, ROP = 120 * 2 * math.pi / 60, 15 / 3600


@pytest.fixture
def bit():
    return bitrock.Bit.load(BIT)


def test_bit(bit):
    cutters = tomllib.loads(BIT.read_text())["cutter"]
    assert len(bit) == len(cutters) == len(bit.radius_m)
    np.testing.assert_allclose(bit.radius_m, [cutter["radius_mm"] * 1e-3 for cutter in cutters])
    assert bitrock.Bit.load(tomllib.loads(BIT.read_text())).name == bit.name


def test_signal_of_the_program(program, bit, model, tmp_path):
    arguments = ["--rpm", 120, "--rop-m-per-h", 15, "--duration-s", 0.5, "--rate-hz", 2000]
    seen = program("signal", BIT, "--model", MODEL, *arguments, "-o", tmp_path / "f.csv")
    with open(tmp_path / "f.csv") as file:
        rows = list(csv.DictReader(file))
    signal = bitrock.signal(bit, model, rotation_rad_per_s=ROTATION, rop_m_per_s=ROP, duration_s=0.5, rate_Hz=2000)
    for name in ("time_s", "angle_rad", "axial_force_N", "torque_N_m"):
        np.testing.assert_array_equal([float(row[name]) for row in rows], getattr(signal, name), err_msg=name)
    assert signal.clamps == seen["clamped"] and signal.draws == seen["windows"]
    assert signal.depth_of_cut_m == seen["depth_of_cut_m"]

    force = bitrock.BitForce(bit, model)
    stepped = [force.at(angle, ROTATION, ROP) for angle in signal.angle_rad]
    np.testing.assert_array_equal(np.array(stepped).T, [signal.axial_force_N, signal.torque_N_m])
    axial, torque = bitrock.BitForce(bit, model).along(signal.angle_rad, ROTATION, ROP)
    np.testing.assert_array_equal([axial, torque], [signal.axial_force_N, signal.torque_N_m])
    assert force.clamps == signal.clamps and force.draws == signal.draws


def test_state_comes_back(bit, model):
    force = bitrock.BitForce(bit, model)
    force.along(np.linspace(0, 3, 100), ROTATION, ROP)
    state, twin = force.save(), copy.copy(force)
    onwards = np.linspace(3, 9, 500)
    first = force.along(onwards, ROTATION, ROP)
    np.testing.assert_array_equal(twin.along(onwards, ROTATION, ROP), first)
    fresh = bitrock.BitForce(bit, model)
    fresh.restore(state)
    np.testing.assert_array_equal(fresh.along(onwards, ROTATION, ROP), first)
    with pytest.raises(bitrock.InputError):
        fresh.restore(state[:-1])


def test_bit_force_keeps_what_it_needs():
    force = bitrock.BitForce(bitrock.Bit.load(BIT), bitrock.Model.load(MODEL))  # both are gone
    kept = bitrock.BitForce(bitrock.Bit.load(BIT), bitrock.Model.load(MODEL))
    angles = np.linspace(0, 20, 200)
    np.testing.assert_array_equal(force.along(angles, ROTATION, ROP), kept.along(angles, ROTATION, ROP))


def test_a_motion_that_is_not_finite(bit, model):
    with pytest.raises(bitrock.SimulationError, match="angle nan rad"):
        bitrock.BitForce(bit, model).at(math.nan, ROTATION, ROP)


def test_drill_run_of_the_program(program, short_drill, tmp_path):
    seen = program("drill", "run", short_drill, "--seed", 4, "-o", tmp_path / "d.h5")
    read, made = bitrock.read_drill(tmp_path / "d.h5"), bitrock.drill_run(short_drill, seed=4)
    series = [name for name in dir(made) if isinstance(getattr(made, name), np.ndarray)]
    assert len(series) == 14
    for name in series:
        np.testing.assert_array_equal(getattr(read, name), getattr(made, name), err_msg=name)
    assert read.summary == made.summary
    assert seen["summary"]["weight_on_bit_N"] == made.summary["weight_on_bit_N"]
    assert seen["summary"]["severity"] == made.summary["severity"]
    assert seen["summary"]["clamped"] == made.clamps and seen["summary"]["windows"] == made.draws
    np.testing.assert_array_equal(read.modes["torsional_Hz"], made.modes["torsional_Hz"])
    assert read.model_fingerprint == made.model_fingerprint != ""
    made.save(tmp_path / "again.h5")
    again = bitrock.read_drill(tmp_path / "again.h5")
    np.testing.assert_array_equal(again.torque_on_bit_N_m, made.torque_on_bit_N_m)


def test_hook_load_of_a_hoist_that_is_fed(short_drill):
    assert bitrock.drill_run(short_drill).hook_load_N.size == 0
    table = tomllib.loads(short_drill.read_text())
    del table["top_drive"]["hook_load_kN"]
    table["top_drive"] |= {"hoist": "autodriller", "weight_on_bit_kN": 15, "line_stiffness_N_per_m": 8e6}
    made = bitrock.drill_run(table)
    assert made.hook_load_N.shape == made.block_speed_m_per_s.shape == made.time_s.shape
    settled = made.hook_load_N[made.time_s >= 0.5]
    assert settled.min() >= made.summary["hook_load_N"]["min"] and settled.max() <= made.summary["hook_load_N"]["max"]
    assert settled.mean() == pytest.approx(made.summary["hook_load_N"]["mean"], rel=0.02)


def test_drill_case_as_a_dict_with_a_model(short_drill, model):
    table = tomllib.loads(short_drill.read_text())
    del table["excitation"]["model"]
    with pytest.raises(bitrock.InputError, match="needs a model"):
        bitrock.drill_run(table)
    made = bitrock.drill_run(table, model=model, seed=4)
    same = bitrock.drill_run(short_drill, seed=4)
    np.testing.assert_array_equal(made.torque_on_bit_N_m, same.torque_on_bit_N_m)
    assert made.model_fingerprint == same.model_fingerprint
    table["rock"] = "marble"
    with pytest.warns(bitrock.BitrockWarning, match="the case is about the rock 'marble'"):
        bitrock.drill_run(table, model=MODEL)
