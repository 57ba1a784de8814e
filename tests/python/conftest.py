"""What the tests share: the program to compare with, and inputs small enough for tests."""

import json
import os
import subprocess
from pathlib import Path

import pytest

import bitrock

SOURCE = Path(os.environ["BITROCK_SOURCE"])
ROCK = SOURCE / "campaigns/rocks/article.toml"
FEATURES = SOURCE / "campaigns/paper240/features.csv"
MODEL = SOURCE / "campaigns/paper240/model.json"
BIT = SOURCE / "campaigns/bits/pdc15.toml"

SMALL_CUT = {
    "cutter_speed_m_per_s": 5.0,
    "depth_of_cut_mm": 1.5,
    "back_rake_deg": 15.0,
    "cut_length_mm": 5.0,
    "bed_length_mm": 15.0,
    "bed_height_mm": 8.0,
}


@pytest.fixture
def program(tmp_path):
    """Runs the program in a folder of its own, and gives what it writes with --json."""

    def run(*arguments, status=0):
        result = tmp_path / "result.json"
        done = subprocess.run(
            [os.environ["BITROCK_PROGRAM"], *map(str, arguments), "--quiet", "--json", result],
            cwd=tmp_path, capture_output=True, text=True,
        )  # fmt: skip
        assert done.returncode == status, done.stderr
        if status != 0:
            return done.stderr.removeprefix("bitrock: ").strip()
        return json.loads(result.read_text())

    return run


@pytest.fixture
def small_case(tmp_path):
    """SMALL_CUT as a file."""
    path = tmp_path / "small.toml"
    path.write_text(
        f"""rock = "{ROCK}"
[cut]
cutter_speed_m_per_s = 5.0
depth_of_cut_mm = 1.5
back_rake_deg = 15.0
cut_length_mm = 5.0
[bed]
length_mm = 15.0
height_mm = 8.0
"""
    )
    return path


@pytest.fixture(scope="session")
def small_run():
    return bitrock.cut(rock=ROCK, seed=3, **SMALL_CUT)


@pytest.fixture(scope="session")
def model():
    return bitrock.Model.load(MODEL)


@pytest.fixture
def short_drill(tmp_path):
    """Two seconds of the shipped normal drilling."""
    text = (SOURCE / "campaigns/drill/normal.toml").read_text()
    for old, new in [
        ("duration_s = 30", "duration_s = 2"),
        ("settling_s = 5", "settling_s = 0.5"),
        ("../bits/pdc15.toml", str(BIT)),
        ("../paper240/model.json", str(MODEL)),
    ]:
        assert old in text
        text = text.replace(old, new)
    path = tmp_path / "short.toml"
    path.write_text(text)
    return path
