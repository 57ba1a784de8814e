import gc
import tomllib

import numpy as np
import pytest
from conftest import ROCK, SMALL_CUT, SOURCE

import bitrock

MACHINE = {"wall_s", "core_s", "ns_per_disc_step"}


def assert_same_runs(a, b):
    for name in ("time_s", "force_x_N_per_m", "force_y_N_per_m", "cracks"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), err_msg=name)
    assert a.energy.keys() == b.energy.keys()
    for name in a.energy:
        np.testing.assert_array_equal(a.energy[name], b.energy[name], err_msg=name)
    for name in ("seed", "discs", "joints", "steps", "step_s", "mean_force_x_N_per_m", "removed_discs", "config_hash"):
        assert getattr(a, name) == getattr(b, name), name
    assert len(a.frames[-1].x_m) == len(b.frames[-1].x_m)
    np.testing.assert_array_equal(a.frames[-1].x_m, b.frames[-1].x_m)


def test_same_bits_as_the_program(program, small_case, small_run, tmp_path):
    seen = program("cut", small_case, "--seed", 3, "-o", tmp_path / "run.h5")
    assert_same_runs(bitrock.read_run(tmp_path / "run.h5"), small_run)
    for name in seen.keys() - MACHINE - {"features"}:
        assert seen[name] == getattr(small_run, name), name
    for axis in "xy":
        assert seen["features"][axis] == small_run.features[axis].as_dict()


def test_a_cut_under_mud_is_the_programs(program, small_case, small_run, tmp_path):
    mud = tmp_path / "mud.toml"
    mud.write_text(small_case.read_text() + "\n[fluid]\npressure_MPa = 5\n")
    seen = program("cut", mud, "--seed", 3, "-o", tmp_path / "run.h5")
    run, file = bitrock.cut(mud, seed=3), bitrock.read_run(tmp_path / "run.h5")
    assert_same_runs(file, run)
    assert_same_runs(bitrock.cut(small_case, seed=3, fluid_pressure_MPa=5), run)
    assert seen["under_mud"] == run.under_mud == file.under_mud
    assert run.under_mud["surface_drop_m"] > 0 and small_run.under_mud is None
    assert run.energy["mud_work_J_per_m"][-1] != 0 and "mud_work_J_per_m" not in small_run.energy
    with pytest.raises(bitrock.InputError, match="debris"):
        bitrock.cut(small_case, fluid_pressure_MPa=5, fluid_debris="wet")


def test_file_dict_and_keywords_are_one_case(small_case, small_run):
    table = tomllib.loads(small_case.read_text())
    assert_same_runs(bitrock.cut(table, seed=3), small_run)
    table["cut"]["depth_of_cut_mm"] = 0.8
    table["bed"]["length_mm"] = 14
    changed = bitrock.cut(table, seed=3, depth_of_cut_mm=1.5, bed_length_mm=15)
    assert_same_runs(changed, small_run)


def test_the_rock_as_a_dict(small_run):
    rock = tomllib.loads(ROCK.read_text())
    assert_same_runs(bitrock.cut(rock=rock, seed=3, **SMALL_CUT), small_run)
    rock["flat_joints"]["tensile_strength_MPa"] *= 2
    assert bitrock.cut(rock=rock, seed=3, **SMALL_CUT).config_hash != small_run.config_hash


def test_a_specimen_of_ones_own(small_run):
    bed = bitrock.specimen(ROCK, seed=3, width_mm=15, height_mm=8)
    assert_same_runs(bitrock.cut(rock=ROCK, seed=3, specimen=bed, **SMALL_CUT), small_run)
    with pytest.raises(bitrock.InputError, match="specimen: "):
        bitrock.cut(rock=ROCK, seed=4, specimen=bed, **SMALL_CUT)


def test_threads_do_not_change_a_bit(small_run):
    assert_same_runs(bitrock.cut(rock=ROCK, seed=3, threads=2, **SMALL_CUT), small_run)


def test_without_energy(small_run):
    run = bitrock.cut(rock=ROCK, seed=3, energy=False, **SMALL_CUT)
    assert run.energy == {} and run.energy_residual_fraction is None
    np.testing.assert_array_equal(run.force_x_N_per_m, small_run.force_x_N_per_m)


def test_saved_and_read_again(small_run, tmp_path):
    small_run.save(tmp_path / "run.h5")
    again = bitrock.read_run(tmp_path / "run.h5")
    assert_same_runs(again, small_run)
    assert again.config_toml == small_run.config_toml
    with pytest.raises(bitrock.InputError, match="copy that file instead"):
        again.save(tmp_path / "other.h5")


def test_frames(tmp_path):
    run = bitrock.cut(rock=ROCK, seed=3, frames=3, energy=False, **SMALL_CUT)
    run.save(tmp_path / "run.h5")
    assert len(bitrock.read_run(tmp_path / "run.h5").frames) == 1
    again = bitrock.read_run(tmp_path / "run.h5", frames=True)
    assert len(run.frames) == len(again.frames) > 1
    for one, other in zip(run.frames, again.frames):
        assert one.time_s == other.time_s
        np.testing.assert_array_equal(one.joint_disc_1, other.joint_disc_1)
    assert len(run.frames[0].joint_disc_1) > 0


def test_arrays_keep_what_they_show(small_run, tmp_path):
    small_run.save(tmp_path / "run.h5")
    force = bitrock.read_run(tmp_path / "run.h5").force_x_N_per_m
    x = bitrock.read_run(tmp_path / "run.h5").frames[-1].x_m
    gc.collect()
    litter = [np.full(len(force), 7.0) for _ in range(50)]  # would lie where a freed array lay
    np.testing.assert_array_equal(force, small_run.force_x_N_per_m)
    np.testing.assert_array_equal(x, small_run.frames[-1].x_m)
    assert len(litter) == 50


def test_arrays_are_views_that_cannot_be_written(small_run):
    a, b = small_run.force_x_N_per_m, small_run.force_x_N_per_m
    assert np.shares_memory(a, b)
    with pytest.raises(ValueError):
        a[0] = 1.0


def test_progress_is_told(small_case):
    told = []
    bitrock.cut(small_case, seed=3, progress=lambda done, total: told.append((done, total)))
    assert len(told) >= 2
    assert all(0 <= done <= total for done, total in told)


def test_progress_as_a_line(small_case, capsys, monkeypatch):
    monkeypatch.setattr("bitrock._progress._BETWEEN_LINES", {True: 0.0, False: 0.0})
    bitrock.cut(small_case, seed=3, progress=True)
    assert "cutting: " in capsys.readouterr().err


def test_warnings_are_those_of_the_program():
    keywords = SMALL_CUT | {"depth_of_cut_mm": 0.5}
    with pytest.warns(bitrock.BitrockWarning, match="below one grain|grain"):
        bitrock.cut(rock=ROCK, seed=3, **keywords)


def test_shipped_case_by_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert bitrock.data_dir().joinpath("campaigns/cuts/example.toml").read_text() == (
        SOURCE / "campaigns/cuts/example.toml"
    ).read_text()
    with pytest.raises(bitrock.InputError, match="bed.length_mm"):
        bitrock.cut("campaigns/cuts/example.toml", bed_length_mm=20)
    (tmp_path / "campaigns/cuts").mkdir(parents=True)
    (tmp_path / "campaigns/cuts/example.toml").write_text("no case")
    with pytest.raises(bitrock.InputError, match="^campaigns/cuts/example.toml:1"):
        bitrock.cut("campaigns/cuts/example.toml")
