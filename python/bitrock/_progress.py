"""The line of `progress=True`."""

import sys
import time

_BETWEEN_LINES = {True: 0.2, False: 5.0}  # [s] on a terminal or in a notebook, and elsewhere


class Line:
    """One line on sys.stderr that says how far a computation is and how long it will still take."""

    def __init__(self, work, unit, per_unit):
        self._work, self._unit, self._per_unit = work, unit, per_unit
        self._begin = self._last = time.monotonic()
        self._redrawn = sys.stderr.isatty() or "ipykernel" in sys.modules
        self._drawn = False

    def show(self, done, total):
        now = time.monotonic()
        if now - self._last < _BETWEEN_LINES[self._redrawn] or not 0 < done <= total:
            return
        self._last = now
        left = (now - self._begin) * (total - done) / done
        amount = f"{done * self._per_unit:.4g} of {total * self._per_unit:.4g} {self._unit}, " if self._unit else ""
        line = f"{self._work}: {amount}{100 * done / total:.0f} %, {left:.0f} s left"
        sys.stderr.write(f"\r{line:<78}" if self._redrawn else line + "\n")
        sys.stderr.flush()
        self._drawn = self._redrawn

    def close(self):
        if self._drawn:
            sys.stderr.write("\r" + 78 * " " + "\r")
            sys.stderr.flush()
