#pragma once
/// What the tests of the runtime share: exact integration of a force over angle, and models that say what a test wants.

#include <algorithm>
#include <array>
#include <vector>

#include "runtime/signal/cutter_force.hpp"
#include "surrogate/net/model.hpp"

using namespace bitrock;

namespace runtime_test {

/// Some 30 peaks on 0.1 m of cut, 0.36 amax in the mean.
inline peaks::PeakRates usual_statistics() {
  return {.amax = 3e5, .amean = 1.1e5, .np1 = 33.0, .np23 = 101.0, .np4 = 160.0};
}

/// As `usual_statistics`, but smaller and with another number of peaks.
inline runtime::CutterStatistics usual_pair() {
  return {.x = usual_statistics(), .y = {.amax = 2e5, .amean = 0.8e5, .np1 = 25.0, .np23 = 150.0, .np4 = 90.0}};
}

/// A whole number of peaks in every band on 25 mm of cut and its multiples: each window has exactly its mean.
inline runtime::CutterStatistics whole_pair() {
  return {.x = {.amax = 3e5, .amean = 1.1e5, .np1 = 40.0, .np23 = 120.0, .np4 = 160.0},
          .y = {.amax = 2e5, .amean = 0.8e5, .np1 = 40.0, .np23 = 160.0, .np4 = 80.0}};
}

inline runtime::SignalSettings usual_settings() {
  runtime::SignalSettings settings;
  settings.window_angle = 1.0;
  settings.seed = 7;
  return settings;
}

inline runtime::CutterForce cutter_force(const runtime::SignalSettings& settings, int cutter, double path_radius) {
  runtime::CutterForce force;
  set_up(force, settings, cutter, path_radius);
  return force;
}

/// Angles between which the force of a train is one polynomial of degree five.
inline std::vector<double> break_points(const runtime::PulseTrain& train, double from, double to) {
  std::vector<double> points{from, to};
  for (const runtime::Pulse& pulse : train.pulses) {
    points.push_back(pulse.centre);
    for (const double inverse : {pulse.inverse_half_width_x, pulse.inverse_half_width_y}) {
      if (inverse > 0.0) points.insert(points.end(), {pulse.centre - 1.0 / inverse, pulse.centre + 1.0 / inverse});
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::remove_if(points.begin(), points.end(), [=](double p) { return p < from || p > to; }),
               points.end());
  return points;
}

/// Gauss-Legendre with six points a piece: exact for degree eleven, so for the square of the force too.
template <class Function>
double integral(const std::vector<double>& points, const Function& function) {
  constexpr std::array<double, 3> node{0.23861918608319690863, 0.66120938646626451366, 0.93246951420315202781};
  constexpr std::array<double, 3> weight{0.46791393457269104739, 0.36076157304813860757, 0.17132449237917034504};
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double middle = 0.5 * (points[i] + points[i - 1]), half = 0.5 * (points[i] - points[i - 1]);
    for (std::size_t n = 0; n < node.size(); ++n) {
      sum += half * weight[n] * (function(middle - half * node[n]) + function(middle + half * node[n]));
    }
  }
  return sum;
}

/// A model that answers `x` and `y` wherever it is asked; trained, so it says, on 0.05-1 m/s, 0.2-4 mm, 10-30 degrees.
inline surrogate::Model constant_model(const runtime::CutterStatistics& answer) {
  surrogate::Model model;
  const std::array<double, 3> low{0.05, 0.2, 10.0}, high{1.0, 4.0, 30.0};
  for (std::size_t i = 0; i < low.size(); ++i) model.inputs[i] = {.low = low[i], .high = high[i]};
  const std::array<peaks::PeakRates, 2> components{answer.x, answer.y};
  for (std::size_t c = 0; c < components.size(); ++c) {
    const peaks::PeakRates& s = components[c];
    const std::array<double, 5> values{s.amax, s.amean, s.np1, s.np23, s.np4};
    for (std::size_t k = 0; k < values.size(); ++k) {
      surrogate::OutputModel& output = model.outputs[5 * c + k];
      output.network.layers = {3, 1};
      output.network.parameters = {0.0, 0.0, 0.0, 1.0};  // output = rectified(0 * inputs + 1)
      output.variable.scale = values[k];
    }
  }
  return model;
}

/// The same, with both heights proportional to the depth of cut; `answer` is what it says at 1 mm.
inline surrogate::Model depth_proportional_model(const runtime::CutterStatistics& answer) {
  surrogate::Model model = constant_model(answer);
  for (const std::size_t height : {0, 1, 5, 6}) model.outputs[height].network.parameters = {0.0, 1.0, 0.0, 0.0};
  return model;
}

}  // namespace runtime_test
