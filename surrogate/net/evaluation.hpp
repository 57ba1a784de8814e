#pragma once
/// What a network and its scaling answer, from plain numbers that lie anywhere: the part of a model that the runtime's
/// core (runtime/core/) computes without a heap, without exceptions and without the C++ library. `network.hpp` and
/// `model.hpp` hold the same numbers in comfortable containers and compute by calling what is here.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bitrock::surrogate {

/// What the last layer does with z[K] = W[K] a[K-1] + b[K].
enum class OutputActivation {
  rectified,  ///< max(0, z), as in the article
  softplus,   ///< ln(1 + e^z), never dead [DugasEtAl2001]
  linear      ///< z; whoever needs an output that is not negative cuts it off (`from_network`)
};

/// Limits that let `forward` work in fixed arrays on the stack. Ten times the article's widest layer.
inline constexpr int widest_layer = 64;
inline constexpr int most_layers = 16;  ///< entries of `layers`, input and output included

inline constexpr int input_count = 3;            ///< speed, depth, rake: what changes while a bit drills
inline constexpr int most_inputs = 16;           ///< of a model, further ones included (further_inputs.hpp)
inline constexpr int article_output_count = 10;  ///< the article's outputs, which every model has
inline constexpr int statistics_count = 5;       ///< of these, of one direction
inline constexpr int moment_count = 7;           ///< outputs that follow the ten, all of them or none
inline constexpr int most_outputs = article_output_count + moment_count;  ///< of a model; the others have ten

inline constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;  ///< one degree

/// SI units in one unit of each input: cutter speed [m/s], depth of cut [mm], back rake [deg].
inline constexpr std::array<double, input_count> si_per_input_unit{1.0, 1e-3, radians_per_degree};

/// What a cut is asked for by, in SI.
struct CutConditions {
  double cutter_speed = 0.0;  ///< [m/s] along the rock surface
  double depth_of_cut = 0.0;  ///< [m]
  double back_rake = 0.0;     ///< [rad]
};

/// z < 0 becomes 0; not-a-number stays what it is, so that a broken input shows in the output.
inline double rectified(double z) {
  return z < 0.0 ? 0.0 : z;
}

/// f(z) of the last layer.
inline double activated(OutputActivation output, double z) {
  switch (output) {
    case OutputActivation::rectified:
      return rectified(z);
    case OutputActivation::softplus:
      return (z < 0.0 ? 0.0 : z) + std::log1p(std::exp(-std::fabs(z)));  // no overflow for large z
    case OutputActivation::linear:
      break;
  }
  return z;
}

/// The numbers of a network as in `network.hpp`, owned by somebody else.
struct NetworkNumbers {
  const int* layers = nullptr;                            ///< n[0], n[1], ..., n[K]
  int layer_count = 0;                                    ///< K + 1
  OutputActivation output = OutputActivation::rectified;  ///< of the last layer
  const double* parameters = nullptr;                     ///< for k = 1..K: W[k] row by row, then b[k]
};

/// Forward pass of n[0] numbers to n[K], for `questions` of them side by side: number i of question q stands in
/// input[i * questions + q], likewise in `output`. For equation, symbols and limits see `Network`. Takes no memory and
/// does not throw. Each sum starts at the bias and runs over the inputs in order, so an export can reproduce the bits,
/// and a question gets the same answer alone as beside others; beside others it costs less, for vectors.
template <int questions = 1>
inline void forward(const NetworkNumbers& network, const double* input, double* output) {
  using Numbers = std::array<double, questions>;
  std::array<Numbers, widest_layer> buffers[2];
  Numbers* from = buffers[0].data();  // a[k-1]
  Numbers* to = buffers[1].data();    // a[k]
  for (int i = 0; i < network.layers[0]; ++i) {
    for (int q = 0; q < questions; ++q) from[i][q] = input[i * questions + q];
  }
  const double* weight = network.parameters;
  for (int k = 1; k < network.layer_count; ++k) {
    const int inputs = network.layers[k - 1], outputs = network.layers[k];
    const double* bias = weight + static_cast<std::ptrdiff_t>(outputs) * inputs;
    for (int o = 0; o < outputs; ++o) {
      Numbers z;
      for (double& number : z) number = bias[o];
      for (int i = 0; i < inputs; ++i, ++weight) {
        for (int q = 0; q < questions; ++q) z[q] += *weight * from[i][q];
      }
      for (int q = 0; q < questions; ++q)
        to[o][q] = k + 1 < network.layer_count ? rectified(z[q]) : activated(network.output, z[q]);
    }
    weight = bias + outputs;
    std::swap(from, to);
  }
  for (int o = 0; o < network.layers[network.layer_count - 1]; ++o) {
    for (int q = 0; q < questions; ++q) output[o * questions + q] = from[o][q];
  }
}

/// The output for what the network gives (`OutputModel`); never negative, because amplitudes and counts are not.
inline double from_network(double offset, double scale, double log_reference, double given) {
  const double seen = offset + scale * given;
  const double value = log_reference > 0.0 ? log_reference * std::expm1(seen) : seen;
  return rectified(value);
}

/// Lowest and highest value of an input that count as inside its training range, in its unit: 1e-9 of the bound
/// wider than the range, so that the rounding of a unit conversion does not fall outside.
struct Bounds {
  double low = 0.0;   ///< lowest value that counts as inside
  double high = 0.0;  ///< highest value that counts as inside
};

/// The bounds of a training range.
inline Bounds widened_range(double low, double high) {
  // Rounding of a unit conversion there and back is a few 1e-16 of the value; 1e-9 is far above it and far below any
  // difference in cutting conditions that somebody could mean.
  const double slack = 1e-9 * std::max(std::fabs(low), std::fabs(high));
  return {.low = low - slack, .high = high + slack};
}

/// The nearest value inside the range low..high (in file units); what lies inside comes back unchanged. SI in and out.
/// (`given` is not called si_value: <signal.h> has a macro of that name.)
inline double clamped_to_range(double low, double high, double given, double si_per_unit) {
  const Bounds bounds = widened_range(low, high);
  const double value = given / si_per_unit;
  if (value < bounds.low) return low * si_per_unit;
  if (value > bounds.high) return high * si_per_unit;
  return given;
}

}  // namespace bitrock::surrogate
