"""The sentences of the program, as exceptions."""

import pytest
from conftest import FEATURES, MODEL, ROCK, SMALL_CUT

import bitrock


def test_kinds():
    assert issubclass(bitrock.InputError, ValueError) and issubclass(bitrock.SimulationError, RuntimeError)
    assert bitrock.InputError.__module__ == "bitrock"


def test_a_wrong_key(program, small_case):
    small_case.write_text(small_case.read_text().replace("depth_of_cut_mm", "depth_of_cut_m"))
    with pytest.raises(bitrock.InputError) as error:
        bitrock.cut(small_case)
    assert str(error.value) == program("cut", small_case, status=2)
    assert "depth_of_cut_mm" in str(error.value)


def test_a_file_that_is_not_there(program):
    for command, read in [
        (["peaks"], bitrock.read_run),
        (["lab", "ucs"], lambda path: bitrock.lab("ucs", path)),
        (["train"], bitrock.train),
    ]:
        with pytest.raises(bitrock.InputError) as error:
            read("nothing.h5")
        assert str(error.value) == program(*command, "nothing.h5", status=2)


def test_a_file_that_cannot_be_written():
    with pytest.raises(bitrock.SimulationError) as error:
        bitrock.Model.load(MODEL).save("/dev/full")
    assert "/dev/full" in str(error.value)


def test_a_training_that_diverges(program):
    with pytest.raises(bitrock.SimulationError) as error:
        bitrock.train(FEATURES, epochs=30, starts=1, learning_rate=1.0, output_activation="linear", layers=[3, 8, 8, 1])
    said = program(
        *["train", FEATURES, "--epochs", 30, "--starts", 1, "--learning-rate", 1.0, "--output-activation", "linear"],
        *["--layers", "3,8,8,1"],
        status=3,
    )
    assert said == "the computation failed: " + str(error.value)


@pytest.mark.parametrize(
    "keywords, sentence",
    [
        ({"depth_of_cut_mm": 0.001}, "depth_of_cut_mm = 0.001 (must be at least 0.01 and at most 100"),
        ({"depth_of_cut_mm": float("nan")}, "depth_of_cut_mm = nan (must be"),
        ({"depth_of_cut_mm": 7}, "cut: cut.depth_of_cut_mm = 7 (at most a third of bed.height_mm"),
        ({"depth": 7}, "unknown keyword 'depth' (there are: cutter_speed_m_per_s, depth_of_cut_mm"),
        ({"seed": -1}, "seed = -1"),
    ],
)
def test_keywords_of_a_cut(keywords, sentence):
    with pytest.raises(bitrock.InputError) as error:
        bitrock.cut(rock=ROCK, **(SMALL_CUT | keywords))
    assert str(error.value).startswith(sentence)


def test_keywords_that_are_missing_or_of_another_type():
    with pytest.raises(bitrock.InputError, match="cutter_speed_m_per_s is missing"):
        bitrock.cut(rock=ROCK)
    with pytest.raises(bitrock.InputError, match="neither a case nor a rock"):
        bitrock.cut()
    with pytest.raises(TypeError, match=r"depth_of_cut_mm = 'two' \(must be a number\)"):
        bitrock.cut(rock=ROCK, **(SMALL_CUT | {"depth_of_cut_mm": "two"}))


def test_dicts_are_checked_as_files_are():
    with pytest.raises(bitrock.InputError, match=r"^rock:1: discs.radius_min_mm is missing"):
        bitrock.specimen({"rock": {"name": "a"}})
    with pytest.raises(TypeError, match="a file holds numbers"):
        bitrock.specimen({"rock": {"name": object()}})
    with pytest.raises(bitrock.InputError):
        bitrock.specimen({"rock": {"name": 'quotes " and\nlines'}})
