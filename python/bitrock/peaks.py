"""A force history reduced to numbers: those of its peaks, which the networks learn, and its moments."""

from bitrock._native import peaks_counted as counted
from bitrock._native import peaks_moments as moments
from bitrock._native import peaks_statistics as statistics

__all__ = ["counted", "moments", "statistics"]
