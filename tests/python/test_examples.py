"""The storyboards run, print the numbers they are about, and stay short."""

import subprocess
import sys

import pytest
from conftest import SOURCE

EXAMPLES = {"own_force.py": "2 s on", "parity.py": "y_np4_per_m"}


@pytest.mark.parametrize("name", EXAMPLES)
def test_example(name, tmp_path):
    path = SOURCE / "examples" / name
    assert len(path.read_text().splitlines()) <= 80
    if name == "parity.py":
        pytest.importorskip("matplotlib")
    done = subprocess.run([sys.executable, path], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert EXAMPLES[name] in done.stdout
    if name == "parity.py":
        assert (tmp_path / "parity.png").read_bytes().startswith(b"\x89PNG")


def test_every_example_is_run():
    assert {path.name for path in (SOURCE / "examples").glob("*.py")} == set(EXAMPLES)
