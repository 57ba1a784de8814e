#pragma once
/// Which cuts teach most for their time: conditions that fill the range of a study evenly, fewer of them where a cut is
/// dear, in batches that go on from each other. Repeats teach less: the scatter of a cut is chaos, not the rock's, so
/// that a new condition has the same scatter and says something of the shape of the force as well.

#include <cstdint>
#include <vector>

#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// The box of conditions that networks are to know.
struct LearnRange {
  double low_speed = 0.0, high_speed = 0.0;        ///< [m/s]
  double low_depth = 0.0, high_depth = 0.0;        ///< [m]
  double low_rake = 0.0, high_rake = 0.0;          ///< [rad]
  double low_pressure = 0.0, high_pressure = 0.0;  ///< of the mud on the rock [Pa]
};

/// From the least to the greatest value of all cases of the study.
LearnRange range_of(const Study& study);

/// A bed is as long and high as its depth of cut asks for, and a rock is made for each bed. So depths stand on so many
/// steps, evenly in their logarithm: the cuts of a batch share few rocks.
inline constexpr int depth_steps = 13;

/// **What** Conditions of a design, in the order they are cut.
/// **Equation** Points of `base::EvenPoints` in four coordinates; three become speed (evenly), depth (its logarithm,
/// evenly) and rake, with 4 % of the points on either face of the range. A point is kept if the fourth is below
/// sqrt(c_min / c), c its time, c_min that of the cheapest point of the range. Where the range has more than one
/// pressure, a fifth coordinate becomes its root, in which forces bend least (`surrogate::SmoothFormula`).
/// **Source** the number of samples of a stratum that gives the least variance for a total cost is as one over the root
/// of the cost of one [Cochran1977].
class LearnDesign {
 public:
  /// `like`: everything but the conditions. Other seeds give other designs.
  LearnDesign(const Study& like, const LearnRange& range, std::uint64_t seed);
  /// Throws `base::InputError` when the range has too few different conditions.
  /// The next so many conditions as a study with one rock, whose seed is that of the design plus the number of the
  /// batch, from 1.
  Study next(int cuts, int batch);

 private:
  double time_of(double speed, double depth) const;

  Study like_;
  LearnRange range_;
  std::uint64_t seed_;
  bool each_has_pressure_ = false;  ///< the cases have pressures of their own, not that of `Study::common`
  double least_time_ = 0.0;         ///< of a cut, in the unit of `work`
  std::int64_t point_ = 0;          ///< of the sequence, the last one taken
};

}  // namespace bitrock::studies
