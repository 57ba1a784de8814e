#pragma once
/// What a cutter is asked to cut, and what the model says about it: from the motion of the bit to the statistics of
/// both directions. The model is plain numbers here, without names and history, so that it fits into the core.

#include <array>
#include <cstdint>
#include <numbers>

#include "runtime/signal/force_moments.hpp"
#include "runtime/signal/peak_statistics.hpp"
#include "runtime/signal/settings.hpp"
#include "runtime/signal/tallies.hpp"
#include "surrogate/net/evaluation.hpp"

namespace bitrock::runtime {

/// A bit turning slower than this is taken to turn at it when depth of cut and cutter speed are asked for: 0.6 rpm. It
/// keeps ROP / N finite while a bit sticks, when its angle, and so its force, stands still anyway. Larger values would
/// make the cuts of a bit that barely turns too shallow; smaller ones change nothing, as the depth is clamped.
inline constexpr double slowest_rotation = 0.0628;  ///< [rad/s]

/// A bit that advances more slowly than this does not cut: at 60 rpm a nanometre a turn, a few atoms, and 3.6 um an
/// hour. Faster, however little, and the networks answer for the shallowest cut they know; so what rounding leaves of a
/// mean of changing rates, 1e-15 m/s and less, must not count as drilling.
inline constexpr double slowest_advance = 1e-9;  ///< [m/s]

/// Whether the bit goes into the rock at this rate [m/s].
inline bool cuts(double rate_of_penetration) {
  return rate_of_penetration > slowest_advance;
}

/// **What** Conditions of one cutter when the bit turns steadily.
/// **Equation** d = 2 pi V / omega; v = omega r.
/// **Symbols** d [m] depth of cut; V [m/s] rate of penetration; omega [rad/s] rotation, at least `slowest_rotation`;
/// v [m/s] cutter speed; r [m] radius of its path.
/// **Source** [BitRock2026, sec. 3.1].
/// **Differences and validity** Holds for one cutter a track. V small against v: the path is taken as a circle.
inline surrogate::CutConditions cut_conditions(double path_radius, double back_rake, double rotation,
                                               double rate_of_penetration) {
  const double omega = rotation < slowest_rotation ? slowest_rotation : rotation;
  return {.cutter_speed = omega * path_radius,
          .depth_of_cut = 2.0 * std::numbers::pi * rate_of_penetration / omega,
          .back_rake = back_rake};
}

/// One input of the model, in the unit of its file.
struct InputNumbers {
  double low = 0.0;     ///< of the training range
  double high = 0.0;    ///< of the training range
  double offset = 0.0;  ///< taken off before scaling
  double scale = 1.0;   ///< above 0
};

/// One output of the model; its parameters lie with those of the others, one after the other.
struct OutputNumbers {
  double offset = 0.0;                                                              ///< of the scaled output
  double scale = 0.0;                                                               ///< of the scaled output
  double log_reference = 0.0;                                                       ///< y_0, or 0
  std::int64_t first_parameter = 0;                                                 ///< its place among all parameters
  std::array<int, surrogate::most_layers> layers{};                                 ///< nodes of each layer
  int layer_count = 0;                                                              ///< of the network
  surrogate::OutputActivation activation = surrogate::OutputActivation::rectified;  ///< of the last layer
};

/// The networks as numbers, without their parameters.
struct ModelNumbers {
  std::array<InputNumbers, surrogate::input_count> inputs;     ///< in the order of `surrogate::input_names`
  std::array<OutputNumbers, surrogate::most_outputs> outputs;  ///< in the order of `surrogate::output_names`
  int output_count = surrogate::article_output_count;          ///< or `surrogate::most_outputs`
};

/// It has seventeen outputs: also those from which sawteeth are made.
inline bool has_moments(const ModelNumbers& model) {
  return model.output_count == surrogate::most_outputs;
}

/// So many cutters are asked about at once: what a vector of any machine takes, and few enough to waste little.
inline constexpr int asked_together = 4;

/// The model's outputs for the conditions of 1 to `asked_together` cutters, moved to the training range first; what was
/// moved is counted. Only what the mode needs is asked for: the rest is 0.
using Answer = std::array<double, surrogate::most_outputs>;
/// An answer for each of `count` conditions.
void ask(const ModelNumbers& model, const double* parameters, SignalMode mode,
         const surrogate::CutConditions* conditions, int count, Answer* answers, ClampTally& clamps);

/// The ten outputs of the article by their names.
CutterStatistics named(const Answer& outputs);

/// The same with pulses so wide that the means of the model are met.
CutterStatistics named_with_means(const Answer& outputs);

/// The six outputs behind the ten.
ForceMoments moments(const Answer& outputs);

}  // namespace bitrock::runtime
