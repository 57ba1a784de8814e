"""bitrock: synthetic rock, cut by one PDC cutter, learnt by small networks, rebuilt as the force on a whole bit.

Arrays are numpy's, numbers carry their unit in the name, and results are those of the program `bitrock`, bit for bit.
docs/guide/python.md begins with an example.
"""

import os as _os


def _load():
    """Imports the C++ side with threads that sleep while they wait, unless the user has chosen otherwise: the OpenMP
    library reads this from the environment once, when it is loaded."""
    chosen = "OMP_WAIT_POLICY" in _os.environ
    _os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    try:
        from bitrock import _native
    finally:
        if not chosen:
            del _os.environ["OMP_WAIT_POLICY"]
    return _native


_native = _load()


class BitrockWarning(UserWarning):
    """What should be looked at although the work goes on."""


from bitrock._native import (  # noqa: E402
    Bit,
    BitForce,
    DrillRun,
    Frame,
    InputError,
    LabResults,
    LabRun,
    Model,
    OutputParity,
    Parity,
    PeakStatistics,
    Run,
    Signal,
    SimulationError,
    Specimen,
    __version__,
    cut,
    data_dir,
    drill_run,
    lab,
    parity,
    read_drill,
    read_features,
    read_run,
    read_specimen,
    signal,
    specimen,
    train,
)
from bitrock import peaks  # noqa: E402

__all__ = [
    "Bit", "BitForce", "BitrockWarning", "DrillRun", "Frame", "InputError", "LabResults", "LabRun", "Model",
    "OutputParity", "Parity", "PeakStatistics", "Run", "Signal", "SimulationError", "Specimen", "__version__", "cut",
    "data_dir", "drill_run", "lab", "parity", "peaks", "read_drill", "read_features", "read_run", "read_specimen",
    "signal", "specimen", "train",
]  # fmt: skip
