import numpy as np
import pytest
from conftest import FEATURES, MODEL

import bitrock


def test_table_of_features():
    table = bitrock.read_features(FEATURES)
    assert list(table)[:4] == ["case", "seed", "cutter_speed_m_per_s", "depth_of_cut_mm"]
    assert table["case"].dtype == np.int64 and table["x_amax_N_per_m"].dtype == np.float64
    assert table["hash"].dtype.kind == "U" and len(table["hash"][0]) == 16
    assert {len(column) for column in table.values()} == {sum(1 for _ in open(FEATURES)) - 1}


def test_predictions_of_the_program(program, model):
    seen = program("predict", MODEL, "--speed-m-per-s", 0.7, "--depth-mm", 1.3, "--rake-deg", 17)
    mine = model.predict(speed_m_per_s=0.7, depth_mm=1.3, rake_deg=17)
    units = {"amax": "N_per_m", "amean": "N_per_m", "np1": "per_m", "np23": "per_m", "np4": "per_m"}
    for axis in "xy":
        for name, unit in units.items():
            assert mine[f"{axis}_{name}_{unit}"] == seen[axis][name]
    assert mine["inside_training_range"] is seen["inside_training_range"] is True


def test_predictions_over_arrays(model):
    speed, depth = np.array([[0.5], [1.0]]), np.array([1, 2, 3])
    many = model.predict(speed_m_per_s=speed, depth_mm=depth, rake_deg=15)
    assert {array.shape for array in many.values()} == {(2, 3)}
    one = model.predict(speed_m_per_s=1.0, depth_mm=2, rake_deg=15)
    assert {name: array[1, 1] for name, array in many.items()} == one
    assert model.predict(speed_m_per_s=[], depth_mm=2, rake_deg=15)["x_amax_N_per_m"].shape == (0,)


def test_outside_the_training_range_is_said(model):
    low = [variable["low"] for variable in model.inputs]
    flags = model.predict(speed_m_per_s=low[0], depth_mm=[low[1], 0.5 * low[1], np.nan], rake_deg=low[2])
    assert list(flags["inside_training_range"]) == [True, False, False]
    assert np.isnan(flags["x_amax_N_per_m"][2])


def test_the_model_file_of_the_program(program, tmp_path):
    program("train", FEATURES, "-o", tmp_path / "p.json", "--epochs", 3, "--seed", 5, "--rock", "r")
    trained = bitrock.train(FEATURES, epochs=3, seed=5, rock="r")
    trained.save(tmp_path / "m.json")
    assert (tmp_path / "m.json").read_bytes() == (tmp_path / "p.json").read_bytes()
    assert bitrock.Model.load(tmp_path / "p.json") == trained != bitrock.train(FEATURES, epochs=2, seed=5, rock="r")


def test_all_options_reach_the_training(program, tmp_path):
    program(
        *["train", FEATURES, "-o", tmp_path / "p.json", "--epochs", 4, "--batch", 7, "--learning-rate", 0.002],
        *["--split", 0.7, "--layers", "3,5,1", "--output-activation", "softplus", "--log-targets", "--smoothing", 2],
        *["--validation", 0.2, "--starts", 2, "--single-cuts", "--weighted", "--from-cases", "--no-shuffle"],
        *["--threads", 1],
    )
    bitrock.train(
        FEATURES, epochs=4, batch=7, learning_rate=0.002, split=0.7, layers=[3, 5, 1], output_activation="softplus",
        log_targets=True, smoothing=2, validation=0.2, starts=2, single_cuts=True, weighted=True, from_cases=True,
        shuffle=False, threads=2,
    ).save(tmp_path / "m.json")  # fmt: skip
    assert (tmp_path / "m.json").read_bytes() == (tmp_path / "p.json").read_bytes()


def test_warm_start(program, model, tmp_path):
    program("train", FEATURES, "-o", tmp_path / "p.json", "--epochs", 2, "--init-from", MODEL)
    bitrock.train(FEATURES, epochs=2, init_from=model).save(tmp_path / "m.json")
    assert (tmp_path / "m.json").read_bytes() == (tmp_path / "p.json").read_bytes()


def test_columns_of_ones_own():
    table = bitrock.read_features(FEATURES)
    from_table, from_file = bitrock.train(table, epochs=2), bitrock.train(FEATURES, epochs=2)
    assert [o["low"] for o in from_table.outputs] == [o["low"] for o in from_file.outputs]
    conditions = {"speed_m_per_s": 0.5, "depth_mm": [1, 2], "rake_deg": 15}
    for name, array in from_table.predict(**conditions).items():
        np.testing.assert_array_equal(array, from_file.predict(**conditions)[name])
    del table["x_np1"]
    with pytest.raises(bitrock.InputError, match="x_np1"):
        bitrock.train(table, epochs=2)


def test_learning_curves_and_provenance():
    trained = bitrock.train(FEATURES, epochs=2)
    assert trained.learning_curves["x_amax_N_per_m"]["epoch"][-1] == 2
    assert trained.provenance["epochs"] == 2
    assert len(trained.provenance["train_cases"]) == 192


def test_parity_of_the_program(program, model):
    seen = program("parity", MODEL, FEATURES)
    parity = bitrock.parity(model, FEATURES)
    assert list(parity.outputs) and parity.outputs.keys() == seen["outputs"].keys()
    for name, output in parity.outputs.items():
        shown = seen["outputs"][name]
        assert output.all == {key: shown[key] for key in output.all}
        assert output.held_out == shown["held_out"] and output.train == shown["train"]
        assert output.times_noise == shown["times_noise"]
    for name in ("same_data", "has_held_out", "outside_training_range"):
        assert getattr(parity, name) == seen[name]


def test_points_of_parity(model):
    output = bitrock.parity(model, FEATURES).outputs["y_amax_N_per_m"]
    held_out = np.isin(output.role, ["test", "unseen"])
    error = output.prediction - output.dem_mean
    assert np.sqrt(np.mean(error[held_out] ** 2)) == pytest.approx(output.held_out["rmse"], rel=1e-12)
    assert held_out.sum() == output.held_out["cases"] == len(model.provenance["test_cases"])
    assert set(bitrock.parity(model, FEATURES, unseen=True).outputs["y_amax_N_per_m"].role) == {"unseen"}


def test_further_inputs_are_held(tmp_path):
    table = {name: column for name, column in bitrock.read_features(FEATURES).items() if name != "hash"}
    table["fluid_pressure_MPa"] = np.where(table["case"] % 2 == 0, 0.0, 20.0)
    model = bitrock.train(table, epochs=2)
    assert [one["name"] for one in model.inputs][3:] == ["fluid_pressure_MPa"]
    with pytest.raises(bitrock.InputError, match="bitrock hold"):
        model.predict(speed_m_per_s=1, depth_mm=2, rake_deg=20)
    held = model.hold(fluid_pressure_MPa=10)
    assert len(held.inputs) == 3
    assert held.predict(speed_m_per_s=1, depth_mm=2, rake_deg=20)["x_amax_N_per_m"] > 0.0
    with pytest.raises(bitrock.InputError, match="from 0 to 20"):
        model.hold(fluid_pressure_MPa=30)
