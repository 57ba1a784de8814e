from numpy import int64
from numpy.typing import ArrayLike, NDArray

from bitrock import PeakStatistics

__all__: list[str]

def statistics(force: ArrayLike) -> PeakStatistics: ...
def counted(force: ArrayLike) -> NDArray[int64]: ...
