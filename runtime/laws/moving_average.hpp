#pragma once
/// Mean of a signal over the last 0.1 s or so, right for steps of any and of changing length. It exists because
/// rotation and rate of penetration are smoothed before they choose the cutting conditions. A plain struct of fixed
/// size: copying it saves and restores its state, it takes no memory and throws nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace bitrock::runtime {

/// Places for the past. A window of 0.1 s is cut into pieces of 0.4 ms or longer; shorter steps share a piece.
inline constexpr int average_places = 256;

struct MovingAverage {
  double window = 0.1;                            ///< [s] above 0 [BitRock2026, sec. 3.3]
  std::array<double, average_places> time{};      ///< [s] ring; ascending from `first`
  std::array<double, average_places> value{};     ///< at those instants
  std::array<double, average_places> integral{};  ///< of the signal from the first sample ever to those instants
  double constant_since = 0.0;                    ///< [s] the signal has had its last value since then
  int first = 0;                                  ///< place of the oldest
  int count = 0;                                  ///< of the entries that count
};
static_assert(std::is_trivially_copyable_v<MovingAverage>);

/// **What** Takes the value of an accepted step into the average. Values of steps that a solver tries and rejects must
/// not come here.
/// **Equation** I(t_n) = I(t_{n-1}) + (t_n - t_{n-1}) (v_n + v_{n-1}) / 2.
/// **Differences and validity** The time must be after the one before and both finite; otherwise nothing changes and
/// the answer is false. A time equal to the last replaces nothing.
inline bool accept(MovingAverage& average, double time, double value) {
  if (!std::isfinite(time) || !std::isfinite(value)) return false;
  if (average.count == 0) {
    average.time[0] = time;
    average.value[0] = value;
    average.integral[0] = 0.0;
    average.constant_since = time;
    average.first = 0;
    average.count = 1;
    return true;
  }
  const auto place = [&](int k) { return static_cast<std::size_t>((average.first + k) % average_places); };
  const std::size_t last = place(average.count - 1);
  if (!(time > average.time[last])) return false;
  if (value != average.value[last]) average.constant_since = time;
  const double integral = average.integral[last] + 0.5 * (time - average.time[last]) * (value + average.value[last]);
  // the last piece grows until it is long enough to stand alone
  const double shortest = average.window / (average_places - 4);
  const bool grows = average.count > 1 && average.time[last] - average.time[place(average.count - 2)] < shortest;
  if (!grows) {
    if (average.count == average_places)
      average.first = static_cast<int>(place(1));
    else
      ++average.count;
  }
  const std::size_t next = place(average.count - 1);
  average.time[next] = time;
  average.value[next] = value;
  average.integral[next] = integral;
  return true;
}

/// **What** The mean over the window that ends with the last accepted sample.
/// **Equation** (I(t) - I(t - T)) / T, t the last time; before a whole window is known, the mean over what is. A signal
/// that did not change in that time has its value as mean, to the last bit.
/// **Symbols** T [s] window; I integral of the straight lines between the samples; within a piece I is taken as the
/// parabola with the right ends and the slopes of its end values.
/// **Differences and validity** Exact for straight lines between samples when no piece holds several; otherwise the
/// error is of second order in T / 252. Gain 1 for a constant, delay T / 2 for a ramp, zeros at multiples of 1 / T.
/// Without a sample: 0. The signal that did not change is a case of its own because the difference of the integrals
/// leaves a rounding, and a bit whose rate of penetration has been 0 for T must be one that does not advance.
inline double mean(const MovingAverage& average) {
  if (average.count == 0) return 0.0;
  const auto place = [&](int k) { return static_cast<std::size_t>((average.first + k) % average_places); };
  const std::size_t last = place(average.count - 1);
  const std::size_t oldest = place(0);
  const double begin = average.time[last] - average.window;
  if (average.constant_since <= std::max(begin, average.time[oldest])) return average.value[last];
  if (begin <= average.time[oldest]) {
    return (average.integral[last] - average.integral[oldest]) / (average.time[last] - average.time[oldest]);
  }
  // begin lies in the piece from `low` on; most pieces are equally long, so the first guess is mostly right
  const double share = (begin - average.time[oldest]) / (average.time[last] - average.time[oldest]);
  int low = std::min(static_cast<int>(share * (average.count - 1)), average.count - 2);
  while (low > 0 && average.time[place(low)] > begin) --low;
  while (low < average.count - 2 && average.time[place(low + 1)] <= begin) ++low;
  const std::size_t a = place(low), b = place(low + 1);
  const double length = average.time[b] - average.time[a], s = begin - average.time[a];
  const double bend = (average.value[b] - average.value[a]) / (2.0 * length);
  const double before =
      average.integral[a] + s * (average.integral[b] - average.integral[a]) / length + bend * s * (s - length);
  return (average.integral[last] - before) / average.window;
}

}  // namespace bitrock::runtime
