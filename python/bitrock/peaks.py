"""A force history reduced to the five numbers the networks learn."""

from bitrock._native import peaks_counted as counted
from bitrock._native import peaks_statistics as statistics

__all__ = ["counted", "statistics"]
