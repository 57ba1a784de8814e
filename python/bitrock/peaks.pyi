from numpy import int64
from numpy.typing import ArrayLike, NDArray

from bitrock import PeakStatistics

__all__: list[str]

def statistics(
    force: ArrayLike, smoothing: float = 0.0, min_prominence: float = 0.0, min_distance: float = 0.0
) -> PeakStatistics: ...
def counted(
    force: ArrayLike, smoothing: float = 0.0, min_prominence: float = 0.0, min_distance: float = 0.0
) -> NDArray[int64]: ...
def moments(force: ArrayLike, spacing: float) -> dict[str, float]: ...
