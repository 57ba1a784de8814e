#!/usr/bin/python3
"""The table of runtime/signal/rise_lengths.hpp: python3 tests/validation/rise_lengths.py

A train of pulses that climb over delta / 10 + rho w^n (1 - s + s w) and drop over delta = 0.4 l_s, w drawn from exp(-w) cut off at 6:
for each p = n + s the lags at which the autocorrelation has fallen to 3/4 (l_s) and 1/e (l), as l_s / l and rho / l.
Some minutes.
"""
import numpy as np

CUT, DROP, LEAST, SHORT = 6.0, 0.4, 0.1, 0.75


def step5(s):
    s = np.clip(s, 0.0, 1.0)
    return s**3 * (10.0 + s * (6.0 * s - 15.0))


def climb(w, p):
    n = int(p)
    return w**n * (1.0 - (p - n) + (p - n) * w)


def lags(p, drop, nodes, samples):
    """Both lags, in units of rho."""
    x, weight = np.polynomial.legendre.leggauss(nodes)
    t = 0.5 * (x + 1.0)
    w = CUT * t * t  # nodes near 0, where short rises lie
    weight = np.exp(-w) / (1.0 - np.exp(-CUT)) * CUT * t * weight
    longest = LEAST * drop + climb(CUT, p)
    step = 1.02 * (longest + drop) / samples
    place = step * np.arange(samples) - longest
    power = 0.0
    for rise, share in zip(LEAST * drop + climb(w, p), weight):
        pulse = np.where(place <= 0.0, step5(place / rise + 1.0), step5(1.0 - place / drop))
        power = power + share * np.abs(np.fft.rfft(pulse, 2 * samples)) ** 2
    r = np.fft.irfft(power)[:samples]
    r /= r[0]

    def first_at(level):
        i = int(np.argmax(r < level))
        return step * (i - (level - r[i]) / (r[i - 1] - r[i]))

    return first_at(SHORT), first_at(np.exp(-1.0))


for p in [k / 10 for k in range(26)]:
    drop = 0.1
    for _ in range(12):
        drop = DROP * lags(p, drop, 120, 1 << 14)[0]
    short, usual = lags(p, drop, 300, 1 << 16)
    print(f"{p:.1f}  {short / usual:.6f}  {1.0 / usual:.6f}")
