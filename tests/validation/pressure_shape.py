#!/usr/bin/python3
"""Over which function of the pressure of the mud the energy of a cut bends least: pressure_shape.py docs/results/mud.md

Reads the rows "pressure P" and the one in bold (20 MPa) of the table of tests/validation/mud.sh. Printed is how far a parabola for the
logarithm of the energy, fitted by least squares, is off at each pressure: over the pressure, its root, and its logarithm.
"""
import re
import sys
from pathlib import Path

import numpy as np


def main():
    page = Path(sys.argv[1]).read_text()
    table = page[page.index("<!-- mud -->"):page.index("<!-- end of mud -->")]
    energy = {}
    for name, value in re.findall(r"^\| (\S.*?) \| \d+ \| ([0-9.]+) \+- ", table, re.M):
        found = re.fullmatch(r"pressure (\d+)|\*\*(20) MPa, .*", name)
        if found:
            energy[float(found[1] or found[2])] = float(value)
    pressure = np.array(sorted(energy))
    seen = np.log([energy[p] for p in pressure])
    for name, x in [("pressure", pressure), ("root", np.sqrt(pressure)), ("logarithm of pressure + 2 MPa", np.log(pressure + 2.0))]:
        off = np.expm1(np.polyval(np.polyfit(x, seen, 2), x) - seen)
        print(f"{name:30}", *(f"{p:g} MPa {100 * o:+.1f} %" for p, o in zip(pressure, off)), sep="  ")


if __name__ == "__main__":
    main()
