#pragma once
/// The damage of the points of a string over a run in a well: cycles of their stress, counted by rainflow, against an
/// S-N curve (fatigue.hpp).

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "runtime/well/stress_histories.hpp"
#include "studies/well/sn_curve.hpp"

namespace bitrock::studies {

/// What is counted, and against what.
struct FatigueWish {
  SnCurve curve;                                        ///< of the steel
  double tensile_strength = 0.0;                        ///< [Pa] of Goodman's line
  double from = -1.0;                                   ///< [s] of the run; below 0: after the settling of the case
  double to = std::numeric_limits<double>::infinity();  ///< [s]
};

/// As long as nobody asks for another curve or steel: B1 in air, quoted from memory, and grade E75 (API 5D), the
/// softest drill pipe.
inline constexpr const char* usual_sn_curve = "B1 air";
inline constexpr double usual_tensile_strength = 689e6;  ///< [Pa]

/// The two, after the settling of the case.
FatigueWish usual_fatigue_wish();

/// One point of the string.
struct PointDamage {
  std::string name;               ///< of the case
  double measured_depth = 0.0;    ///< [m] at the end of the run
  double damage_per_hour = 0.0;   ///< [1/h]
  double hours_to_failure = 0.0;  ///< [h]; infinite without damage
  double cycles_per_hour = 0.0;   ///< [1/h] of ranges above a hundredth of the largest
  double largest_range = 0.0;     ///< [Pa]
  double mean = 0.0;              ///< [Pa] of the stress
};

/// In the order of the case. Throws `base::InputError` when the run has no stress points, or fewer than 3 samples in
/// the time that counts, and `base::SimulationError` when the mean stress alone breaks the steel.
std::vector<PointDamage> damage_of(const runtime::StressHistories& run, const FatigueWish& wish,
                                   const std::string& file);

/// The samples that count.
struct CountedTime {
  std::size_t begin = 0, count = 0;  ///< of the samples of the run
  double hours = 0.0;                ///< [h] from the first of them to the last
};
/// Throws `base::InputError` when there are fewer than 3.
CountedTime counted_time(const runtime::StressHistories& run, const FatigueWish& wish, const std::string& file);

/// Of one fibre, its stress [Pa] over so many hours.
PointDamage damage_of_history(const std::string& name, double measured_depth, std::span<const double> stress,
                              double hours, const FatigueWish& wish);

/// A curve from a table with the columns stress_range_MPa and cycles. Throws `base::InputError`.
SnCurve read_sn_curve(const std::string& file);

}  // namespace bitrock::studies
