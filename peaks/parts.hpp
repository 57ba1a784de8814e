#pragma once
/// Peaks by part of the window: the history cut into equal parts (four are its quadrants), and in each the peaks of
/// every band and the share without force. It is what the article would add to the inputs of its networks so that
/// periods without force come back [BitRock2026, sec. 5]; parts of time are parts of the angle while a bit turns
/// evenly.
///
/// Sample i of n belongs to part floor(i parts / n). With a time axis t the place of sample i is
/// (t_i - t_0) (n - 1) / (t_{n-1} - t_0) in place of i, so that evenly spaced samples fall into the same parts as
/// without; a millionth of a sample is added, for t is rounded. A peak belongs to the part of its first sample, even
/// when its flat top reaches into the next. Peaks are those of the whole window: a border ends no slope, and least
/// height and bands refer to the whole window, too. Hence the counts of the parts add up to those of the window.

#include <cstddef>
#include <span>
#include <vector>

#include "peaks/statistics.hpp"
#include "peaks/zero_force.hpp"

namespace bitrock::peaks {

/// One part of the window.
struct Part {
  std::size_t begin = 0, end = 0;  ///< samples [begin, end)
  PeakStatistics peaks;            ///< amax and amean of this part; bands are shares of the A_max of the window
  ZeroForce zero_force;            ///< a period that reaches over a border counts in both parts
};

/// First samples of `parts` (1 or more) equal parts of n samples, and n.
std::vector<std::size_t> part_borders(std::size_t samples, int parts);

/// The same by time: finite, never falling, the last above the first. Parts without a sample are possible.
std::vector<std::size_t> part_borders(std::span<const double> time, int parts);

/// A part between each two of the `borders`, which are those of `part_borders` for this signal.
std::vector<Part> statistics_by_part(std::span<const double> signal, std::span<const std::size_t> borders,
                                     const Selection& selection = {});

}  // namespace bitrock::peaks
