#pragma once
/// Fewer points for the same picture. A long signal has many samples in each column of pixels, and all that can be
/// seen of them is where the line enters, leaves, and how far it reaches. So a run of samples is replaced by its first,
/// lowest, highest and last one [JugelEtAl2014]: no peak is lost, and the line looks the same as long as a run is no
/// wider than a column of pixels. With 4000 runs that holds on any screen until one zooms in a few times.
/// It changes pictures only, never numbers that anybody computes with.

#include <cstddef>
#include <span>
#include <vector>

namespace bitrock::base {

/// Longest line that is drawn point for point.
inline constexpr std::size_t longest_whole_line = 20'000;

/// Increasing indices of the samples to draw: all of them up to `most`, otherwise first, lowest, highest and last of
/// each of `most` / 5 equal runs, and the first missing value (NaN or infinite) of a run, so that gaps stay gaps.
/// At most `most` indices come back, for `most` >= 5.
std::vector<std::size_t> envelope(std::span<const double> y, std::size_t most = longest_whole_line);

}  // namespace bitrock::base
