#pragma once
/// Rainflow: the closed cycles of a load history, found while it comes in.
///
/// **Rule.** Of the turning points, the range Y between the last but one pair is a cycle when the range X after it is
/// at least as large: it counts as one and its two points are taken out, or as a half when Y begins at the first point
/// that is left, which alone is taken out. What is left at the end counts as half cycles.
///
/// **Source.** [ASTM_E1049, rainflow counting], as widely reproduced.
///
/// **Damage-equivalent range.** With m the exponent of the S-N curve and L the travel,
///
///     R_eq = (sum n_i r_i^m / L)^(1/m)        [N/m per (m of travel)^(1/m)]
///
/// the range of one cycle a unit of travel that does the same damage. **Symbols.** r_i ranges, n_i 1 or 1/2.

#include <cmath>
#include <span>
#include <vector>

namespace bitrock::peaks {

/// `count(range, mean, cycles)` is called for each cycle, `cycles` being 1 or 0.5.
template <class Count>
class Rainflow {
 public:
  explicit Rainflow(Count count) : count_(count) {}  ///< called by `add` and `finish`

  /// The next value of the history; cycles that it closes are counted now.
  void add(double value) {
    if (!turns_.empty() && value == turns_.back()) return;
    const std::size_t size = turns_.size();
    // the last point is a turning point only when the history turns there
    const bool goes_on = size >= 2 && (turns_[size - 1] - turns_[size - 2]) * (value - turns_[size - 1]) > 0.0;
    if (goes_on) {
      turns_.back() = value;
    } else {
      turns_.push_back(value);
    }
    close_cycles();
  }

  /// The rest, as half cycles; the counter is empty afterwards.
  void finish() {
    for (std::size_t i = 1; i < turns_.size(); ++i) half(turns_[i - 1], turns_[i]);
    turns_.clear();
  }

 private:
  void half(double from, double to) { count_(std::fabs(to - from), 0.5 * (from + to), 0.5); }

  void close_cycles() {
    while (turns_.size() >= 3) {
      const std::size_t n = turns_.size();
      const double x = std::fabs(turns_[n - 1] - turns_[n - 2]), y = std::fabs(turns_[n - 2] - turns_[n - 3]);
      if (x < y) return;
      if (n == 3) {  // y begins at the first point
        half(turns_[0], turns_[1]);
        turns_.erase(turns_.begin());
      } else {
        count_(y, 0.5 * (turns_[n - 3] + turns_[n - 2]), 1.0);
        turns_.erase(turns_.end() - 3, turns_.end() - 1);
      }
    }
  }

  Count count_;
  std::vector<double> turns_;
};

/// Of a whole history, `travel` long, above 0.
inline double damage_equivalent_range(std::span<const double> signal, double travel, double exponent) {
  double sum = 0.0;
  Rainflow rainflow(
      [&sum, exponent](double range, double, double cycles) { sum += cycles * std::pow(range, exponent); });
  for (const double value : signal) rainflow.add(value);
  rainflow.finish();
  return std::pow(sum / travel, 1.0 / exponent);
}

}  // namespace bitrock::peaks
