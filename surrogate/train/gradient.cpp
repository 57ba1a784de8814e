#include "surrogate/train/gradient.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "surrogate/net/layers.hpp"

namespace bitrock::surrogate {

namespace {

/// a[k] (B x n[k]) = f(a[k-1] (B x n[k-1]) W[k]^T + b[k]), f of a hidden layer or of the output.
template <class Activation>
void forward_layer(const Layer& seen, int rows, const Activation& f, const std::vector<double>& below,
                   std::vector<double>& above) {
  const Eigen::Index inputs = seen.weights.cols(), outputs = seen.weights.rows();
  above.resize(static_cast<std::size_t>(rows * outputs));
  for (Eigen::Index b = 0; b < rows; ++b) {
    const double* from = below.data() + b * inputs;
    for (Eigen::Index o = 0; o < outputs; ++o) {
      double z = seen.biases(o);
      for (Eigen::Index i = 0; i < inputs; ++i) z += seen.weights(o, i) * from[i];
      above[static_cast<std::size_t>(b * outputs + o)] = f(z);
    }
  }
}

/// dL/dW[k] (n[k] x n[k-1]) = d[k]^T a[k-1], then dL/db[k] (n[k]) = column sums of d[k], into their place.
void gradient_layer(int rows, int inputs, int outputs, const std::vector<double>& below,
                    const std::vector<double>& delta, double* gradient) {
  double* biases = gradient + outputs * inputs;
  std::fill(gradient, biases + outputs, 0.0);
  for (int b = 0; b < rows; ++b) {
    for (int o = 0; o < outputs; ++o) {
      const double d = delta[static_cast<std::size_t>(b * outputs + o)];
      for (int i = 0; i < inputs; ++i) gradient[o * inputs + i] += d * below[static_cast<std::size_t>(b * inputs + i)];
      biases[o] += d;
    }
  }
}

/// d[k-1] (B x n[k-1]) = (d[k] (B x n[k]) W[k]) where a[k-1] > 0, else 0.
void delta_layer(const Layer& seen, int rows, const std::vector<double>& below, const std::vector<double>& delta,
                 std::vector<double>& delta_below) {
  const Eigen::Index inputs = seen.weights.cols(), outputs = seen.weights.rows();
  delta_below.assign(static_cast<std::size_t>(rows * inputs), 0.0);
  for (Eigen::Index b = 0; b < rows; ++b) {
    const double* from = delta.data() + b * outputs;
    for (Eigen::Index i = 0; i < inputs; ++i) {
      const auto at = static_cast<std::size_t>(b * inputs + i);
      if (!(below[at] > 0.0)) continue;
      for (Eigen::Index o = 0; o < outputs; ++o) delta_below[at] += from[o] * seen.weights(o, i);
    }
  }
}

double row_weight(const Batch& batch, std::size_t row) {
  return batch.weights.empty() ? 1.0 : batch.weights[row];
}

}  // namespace

double loss_and_gradient(const Network& network, const Batch& batch, GradientBuffers& buffers,
                         std::span<double> gradient) {
  const int last = static_cast<int>(network.layers.size()) - 1;  // K
  const auto width = [&network](int k) { return network.layers[static_cast<std::size_t>(k)]; };
  const auto activation = [&buffers](int k) -> auto& {
    return buffers.activations[static_cast<std::size_t>(k)];
  };
  buffers.activations.resize(network.layers.size());
  activation(0).assign(batch.inputs.begin(), batch.inputs.end());
  for (int k = 1; k < last; ++k) {
    forward_layer(layer(network, k), batch.rows, rectified, activation(k - 1), activation(k));
  }
  forward_layer(
      layer(network, last), batch.rows, [&](double z) { return activated(network.output, z); }, activation(last - 1),
      activation(last));

  const std::vector<double>& outputs = activation(last);
  const auto count = static_cast<double>(outputs.size());  // B n[K]
  double sum = 0.0;
  buffers.delta.resize(outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const double error = outputs[i] - batch.targets[i];
    const double weight = row_weight(batch, i / static_cast<std::size_t>(width(last)));
    sum += weight * error * error;
    buffers.delta[i] = 2.0 / count * weight * error * activation_slope(network.output, outputs[i]);
  }

  for (int k = last; k >= 1; --k) {
    gradient_layer(batch.rows, width(k - 1), width(k), activation(k - 1), buffers.delta,
                   gradient.data() + layer_offset(network.layers, k));
    if (k == 1) break;
    delta_layer(layer(network, k), batch.rows, activation(k - 1), buffers.delta, buffers.delta_below);
    std::swap(buffers.delta, buffers.delta_below);
  }
  return sum / count;
}

double mean_squared_error(const Network& network, const Batch& batch) {
  if (batch.rows == 0) return 0.0;
  const auto inputs = static_cast<std::size_t>(network.layers.front());
  const auto outputs = static_cast<std::size_t>(network.layers.back());
  std::array<double, widest_layer> output;
  double sum = 0.0;
  for (std::size_t b = 0; b < static_cast<std::size_t>(batch.rows); ++b) {
    forward(network, batch.inputs.subspan(b * inputs, inputs), std::span(output).first(outputs));
    for (std::size_t j = 0; j < outputs; ++j) {
      const double error = output[j] - batch.targets[b * outputs + j];
      sum += row_weight(batch, b) * error * error;
    }
  }
  return sum / static_cast<double>(batch.targets.size());
}

}  // namespace bitrock::surrogate
