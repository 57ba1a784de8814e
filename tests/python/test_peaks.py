import tracemalloc

import numpy as np
import pytest

import bitrock
from bitrock import peaks


def test_statistics_of_a_force_with_known_peaks():
    force = np.array([0, 100, 0, 60, 0, 20, 0, 0.5, 0, 100, 100, 0])
    s = peaks.statistics(force)
    assert (s.amax, s.amean, s.np1, s.np23, s.np4, s.count) == (100.0, 70.0, 2, 1, 1, 4)
    assert list(peaks.counted(force)) == [1, 3, 5, 9]
    assert s.as_dict() == {"amax": 100.0, "amean": 70.0, "np1": 2, "np23": 1, "np4": 1}


def test_same_numbers_as_the_program(program, tmp_path, small_run):
    small_run.save(tmp_path / "run.h5")
    seen = program("peaks", tmp_path / "run.h5", "--column", "y_N_per_m")
    s = peaks.statistics(small_run.force_y_N_per_m)
    assert {name: seen[name] for name in ("amax", "amean", "np1", "np23", "np4", "count")} == s.as_dict() | {
        "count": s.count
    }
    assert [peak["index"] for peak in seen["peaks"]] == list(peaks.counted(small_run.force_y_N_per_m))


@pytest.mark.parametrize("dtype", ["float32", "int16", "uint8", "bool"])
def test_other_numbers_are_converted(dtype):
    force = np.array([0, 1, 0, 1, 0], dtype=dtype)
    assert peaks.statistics(force).np1 == 2


def test_lists_and_strided_arrays():
    assert peaks.statistics([0, 3, 0]).amax == 3.0
    both = np.array([[0, 9], [3, 9], [0, 9]], dtype=float)
    assert peaks.statistics(both[:, 0]).amax == 3.0


def memory_taken(force):
    tracemalloc.start()
    peaks.statistics(force)
    taken = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return taken


def test_float64_is_read_in_place_and_others_are_not():
    force = np.zeros(1_000_000)
    assert memory_taken(force) < 100_000
    assert memory_taken(force.astype("float32")) >= 8_000_000


def test_a_missing_sample_is_no_peak():
    assert peaks.statistics([0, 5, 0, 3, np.nan, 0, 4, 0]).count == 2


@pytest.mark.parametrize("force", [np.zeros((3, 4)), 1.0])
def test_only_one_dimension(force):
    with pytest.raises(bitrock.InputError, match=r"force: an array of shape .* \(must have one dimension\)"):
        peaks.statistics(force)


@pytest.mark.parametrize("force", [np.zeros(3, dtype=complex), ["1", "2"], [None, 1.0]])
def test_only_real_numbers(force):
    with pytest.raises(bitrock.InputError, match=r"force: values of type .* \(must be real numbers\)"):
        peaks.statistics(force)


def test_prominence_and_distance_are_those_of_scipy():
    signal = pytest.importorskip("scipy.signal")
    random = np.random.default_rng(4)
    force = np.maximum(0.0, np.cumsum(random.normal(size=3000)) % 7.0 + random.normal(size=3000))
    for share in (0.02, 0.1, 0.3):
        found, _ = signal.find_peaks(force, height=np.nextafter(0.01 * force.max(), 9), prominence=share * force.max())
        assert list(peaks.counted(force, min_prominence=share)) == list(found)
    for distance in (2, 5, 17):
        found, _ = signal.find_peaks(force, height=np.nextafter(0.01 * force.max(), 9), distance=distance + 1)
        assert list(peaks.counted(force, min_distance=distance)) == list(found)


def test_smoothing_has_the_variance_of_two_means_over_its_length():
    force = np.array([0.0, 0, 0, 0, 12, 0, 0, 0, 0])
    assert peaks.statistics(force).amax == 12.0
    # two passes of (a, 1, a) / (1 + 2 a) with the variance (2 * 2 ** 2 - 1) / 24 each
    a = 7 / 24 / (2 * (1 - 7 / 24))
    middle, side = 1 / (1 + 2 * a), a / (1 + 2 * a)
    assert peaks.statistics(force, smoothing=2.0).amax == pytest.approx(12.0 * (middle**2 + 2 * side**2))
    with pytest.raises(bitrock.InputError, match="min_prominence"):
        peaks.statistics(force, min_prominence=1.5)


def test_moments_of_a_wave():
    force = 3.0 + 2.0 * np.sin(2 * np.pi * np.arange(100_000) / 1000)
    seen = peaks.moments(force, spacing=1e-6)
    assert seen["mean"] == pytest.approx(3.0)
    assert seen["sd"] == pytest.approx(np.sqrt(2.0))
    assert seen["correlation_length"] == pytest.approx(1e-3 * np.arccos(np.exp(-1)) / (2 * np.pi), rel=1e-2)
    assert seen["short_correlation_length"] == pytest.approx(1e-3 * np.arccos(0.75) / (2 * np.pi), rel=1e-2)
    assert seen["low_share"] == 0.0
