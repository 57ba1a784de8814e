import math

import numpy as np
import pytest
from conftest import ROCK

import bitrock

SMALL_CORE = {"width_mm": 10, "height_mm": 20}


def test_specimen_of_the_program(program, tmp_path):
    seen = program("specimen", ROCK, "--seed", 2, "--width-mm", 10, "--height-mm", 20, "-o", tmp_path / "s.h5")
    read, made = bitrock.read_specimen(tmp_path / "s.h5"), bitrock.specimen(ROCK, seed=2, **SMALL_CORE)
    for name in ("x_m", "y_m", "radius_m", "joint_disc_1", "joint_disc_2"):
        np.testing.assert_array_equal(getattr(read, name), getattr(made, name), err_msg=name)
    for name in ("porosity", "coordination_number", "floaters", "width_m", "height_m", "seed", "pressure_Pa"):
        assert seen[name] == getattr(made, name), name
    made.save(tmp_path / "again.h5")
    assert (tmp_path / "again.h5").read_bytes() == (tmp_path / "s.h5").read_bytes()


@pytest.mark.parametrize("test", ["ucs", "tension", "brazilian"])
def test_same_bits_as_the_program(program, test, recwarn):
    size = {"width_mm": 10} | ({} if test == "brazilian" else {"height_mm": 20})
    flags = [f for name, value in size.items() for f in ("--" + name.replace("_", "-"), value)]
    seen = program("lab", test, ROCK, "--seeds", "1,2", *flags)
    results = bitrock.lab(test, ROCK, seeds=[1, 2], **size)
    assert len(results.runs) == len(seen["runs"]) == 2
    for run, shown in zip(results.runs, seen["runs"]):
        for name in shown.keys() - {"wall_s"}:
            value = getattr(run, name)
            assert shown[name] == value or (shown[name] is None and math.isnan(value)), name
    for kind in ("mean", "sd"):
        for name, value in getattr(results, kind).items():
            assert seen[kind][name] == value or (seen[kind][name] is None and math.isnan(value)), name
    assert results.failures == []
    assert any("laboratory asks for at least" in str(warning.message) for warning in recwarn)


@pytest.mark.filterwarnings("ignore::bitrock.BitrockWarning")
def test_triaxial_is_the_programs(program):
    seen = program("lab", "triaxial", ROCK, "--seeds", "1,2", "--confining-pressures-MPa", "0,5", "--width-mm", 10,
                   "--height-mm", 20)
    results = bitrock.lab("triaxial", ROCK, seeds=[1, 2], confining_pressures_MPa=[0, 5], **SMALL_CORE)
    assert [(run.confining_pressure_Pa, run.seed) for run in results.runs] == [(0, 1), (0, 2), (5e6, 1), (5e6, 2)]
    assert [run["peak_stress_Pa"] for run in seen["runs"]] == [run.peak_stress_Pa for run in results.runs]
    for name, value in seen["envelope"]["mean"].items():
        assert results.envelope[name] == value, name
        assert results.envelope["sd_" + name] == seen["envelope"]["sd"][name], name
    with pytest.raises(bitrock.InputError, match="confining_pressures_MPa"):
        bitrock.lab("triaxial", ROCK)
    with pytest.raises(bitrock.InputError, match="confining_pressures_MPa"):
        bitrock.lab("ucs", ROCK, confining_pressures_MPa=[5])


@pytest.mark.filterwarnings("ignore::bitrock.BitrockWarning")
def test_toughness_is_the_programs(program):
    seen = program("lab", "toughness", ROCK, "--seed", 1, "--notch-lengths-mm", "3,5", "--width-mm", 10, "--height-mm", 20)
    results = bitrock.lab("toughness", ROCK, notch_lengths_mm=[3, 5], **SMALL_CORE)
    assert [run.notch_length_m for run in results.runs] == [3e-3, 5e-3]
    assert [run["fracture_toughness_Pa_sqrt_m"] for run in seen["runs"]] == [
        run.fracture_toughness_Pa_sqrt_m for run in results.runs]
    assert [row["notch_length_m"] for row in seen["by_notch"]] == [3e-3, 5e-3]
    usual = bitrock.lab("toughness", ROCK, **SMALL_CORE)  # 0.4 of the width
    assert usual.runs[0].notch_length_m == pytest.approx(4e-3)
    with pytest.raises(bitrock.InputError, match="length of the notch"):
        bitrock.lab("toughness", ROCK, notch_lengths_mm=[9.5], **SMALL_CORE)
    with pytest.raises(bitrock.InputError, match="notch_lengths_mm"):
        bitrock.lab("tension", ROCK, notch_lengths_mm=[3], **SMALL_CORE)


@pytest.mark.filterwarnings("ignore::bitrock.BitrockWarning")
def test_seeds_and_curve():
    by_text = bitrock.lab("tension", ROCK, seeds="2:3", jobs=1, **SMALL_CORE)
    by_list = bitrock.lab("tension", ROCK, seeds=np.array([2, 3]), **SMALL_CORE)
    assert [run.seed for run in by_text.runs] == [run.seed for run in by_list.runs] == [2, 3]
    curve = by_text.runs[0].curve
    assert list(curve) == ["strain", "lateral_strain", "stress_Pa", "cracks_tensile", "cracks_shear"]
    assert curve["stress_Pa"].max() == by_text.runs[0].peak_stress_Pa
    assert len(by_text.runs[0].cracks) == by_text.runs[0].cracks_tensile + by_text.runs[0].cracks_shear


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        (("shear", {}), "test 'shear' (must be ucs, tension, brazilian, triaxial or toughness)"),
        (("brazilian", {"height_mm": 10}), "height_mm: a Brazilian disc has its diameter only"),
        (("tension", {"platen_friction": 0.1}), "platen_friction: there are no platens"),
        (("ucs", {"width_mm": 0.0}), "width_mm = 0"),
        (("ucs", {"seeds": []}), "seeds: none"),
        (("ucs", {"seeds": "1,x"}), "seeds"),
        (("ucs", {"local_damping": 2.0}), "local damping = 2"),
    ],
)
def test_what_makes_no_test(arguments, sentence):
    test, keywords = arguments
    with pytest.raises(bitrock.InputError) as error:
        bitrock.lab(test, ROCK, **keywords)
    assert sentence in str(error.value)


@pytest.mark.filterwarnings("ignore::bitrock.BitrockWarning")
def test_a_specimen_of_ones_own():
    core = bitrock.specimen(ROCK, seed=2, **SMALL_CORE)
    given = bitrock.lab("tension", ROCK, specimen=core).runs[0]
    assert given.peak_stress_Pa == bitrock.lab("tension", ROCK, seeds=2, **SMALL_CORE).runs[0].peak_stress_Pa
    with pytest.raises(bitrock.InputError, match="it has its own seed and size"):
        bitrock.lab("tension", ROCK, specimen=core, seeds=1)


def test_seeds_are_whole_numbers():
    with pytest.raises(TypeError, match=r"seeds: 1.5 \(must be whole numbers\)"):
        bitrock.lab("ucs", ROCK, seeds=[1, 1.5])
