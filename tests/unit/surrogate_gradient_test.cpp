// Back-propagation against central differences, parameter by parameter, and one net derived by hand.
#include "surrogate/train/gradient.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "surrogate/net/layers.hpp"

using namespace bitrock;

namespace {

using surrogate::Batch;
using surrogate::Network;
using surrogate::OutputActivation;

struct Sample {
  int rows;
  std::vector<double> inputs, targets, weights;
  Batch batch() const { return {rows, inputs, targets, weights}; }
};

Sample random_sample(base::Random& random, const Network& network, int rows) {
  Sample sample{rows, {}, {}, {}};
  for (int i = 0; i < rows * network.layers.front(); ++i) sample.inputs.push_back(base::uniform(random, -1.0, 1.0));
  for (int i = 0; i < rows * network.layers.back(); ++i) sample.targets.push_back(base::uniform(random));
  return sample;
}

/// The smallest |z| of any unit for any row: how near the sample is to a kink of the rectifier.
double distance_to_kink(const Network& network, const Sample& sample) {
  double nearest = std::numeric_limits<double>::infinity();
  const int width = network.layers.front();
  for (int row = 0; row < sample.rows; ++row) {
    Eigen::VectorXd a = Eigen::Map<const Eigen::VectorXd>(sample.inputs.data() + row * width, width);
    for (int k = 1; k < static_cast<int>(network.layers.size()); ++k) {
      const surrogate::Layer layer = surrogate::layer(network, k);
      const Eigen::VectorXd z = layer.weights * a + layer.biases;
      nearest = std::min(nearest, z.cwiseAbs().minCoeff());
      a = z.cwiseMax(0.0);
    }
  }
  return nearest;
}

/// Random networks (biases too) whose samples lie away from every kink. In one parameter the loss is then a quadratic,
/// for which the central difference is exact, so only rounding remains: about 1e-16 / step. With a softplus output the
/// third derivative adds about step^2 / 6 of it, 2e-11.
void compare_with_central_differences(const std::vector<int>& layers, int rows,
                                      OutputActivation output = OutputActivation::rectified, bool weighted = false) {
  constexpr double step = 1e-5, margin = 1e-3, tolerance = 1e-7;
  constexpr int wanted = 100;
  base::Random random(17);
  Network network{.layers = layers, .output = output, .parameters = {}};
  std::vector<double> largest(surrogate::parameter_count(layers), 0.0);
  int compared = 0;
  for (int trial = 0; trial < 10000 && compared < wanted; ++trial) {
    surrogate::initialise(network, random);
    for (double& parameter : network.parameters) parameter += 0.3 * base::normal(random);
    Sample sample = random_sample(random, network, rows);
    for (int i = 0; weighted && i < rows; ++i) sample.weights.push_back(base::uniform(random, 0.0, 3.0));
    if (distance_to_kink(network, sample) < margin) continue;
    surrogate::GradientBuffers buffers;
    std::vector<double> gradient(network.parameters.size());
    const double loss = surrogate::loss_and_gradient(network, sample.batch(), buffers, gradient);
    if (std::all_of(gradient.begin(), gradient.end(), [](double g) { return g == 0.0; })) continue;  // dead
    EXPECT_DOUBLE_EQ(loss, surrogate::mean_squared_error(network, sample.batch()));
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      Network moved = network;
      moved.parameters[i] = network.parameters[i] + step;
      const double above = surrogate::mean_squared_error(moved, sample.batch());
      moved.parameters[i] = network.parameters[i] - step;
      const double below = surrogate::mean_squared_error(moved, sample.batch());
      EXPECT_NEAR(gradient[i], (above - below) / (2.0 * step), tolerance * std::max(1.0, std::abs(gradient[i])))
          << "parameter " << i << ", trial " << trial;
      largest[i] = std::max(largest[i], std::abs(gradient[i]));
    }
    ++compared;
  }
  EXPECT_EQ(compared, wanted);
  // Not one parameter was compared as 0 = 0 only.
  EXPECT_GT(*std::min_element(largest.begin(), largest.end()), 1e-4);
}

TEST(SurrogateGradient, EveryParameterAgreesWithCentralDifferences) {
  compare_with_central_differences({3, 4, 6, 3, 1}, 4);
}

TEST(SurrogateGradient, AgreesForOneRowOneLayerAndSeveralOutputs) {
  compare_with_central_differences({3, 4, 6, 3, 1}, 1);
  compare_with_central_differences({3, 1}, 4);
  compare_with_central_differences({2, 5, 3}, 7);
}

TEST(SurrogateGradient, AgreesForOtherOutputsAndForWeightedRows) {
  compare_with_central_differences({3, 4, 6, 3, 1}, 4, OutputActivation::softplus);
  compare_with_central_differences({3, 4, 6, 3, 1}, 4, OutputActivation::linear);
  compare_with_central_differences({2, 5, 3}, 7, OutputActivation::softplus, true);
  compare_with_central_differences({3, 4, 6, 3, 1}, 4, OutputActivation::rectified, true);
}

TEST(SurrogateGradient, AgreesWithAHandComputedNet) {
  // a1 = relu(2 x - 1), y = relu(3 a1 + 0.5); rows x = 1, t = 3 and x = 0, t = 1.
  // Row 1: a1 = 1, y = 3.5, e = 0.5. Row 2: z1 = -1, a1 = 0, y = 0.5, e = -0.5. L = (0.25 + 0.25) / 2 = 0.25.
  // d2 = 2/2 e = (0.5, -0.5): dW2 = 0.5 * 1 = 0.5, db2 = 0. d1 = 3 * 0.5 = 1.5 in row 1 only: dW1 = 1.5, db1 = 1.5.
  const Network network{.layers = {1, 1, 1}, .parameters = {2.0, -1.0, 3.0, 0.5}};
  const Sample sample{2, {1.0, 0.0}, {3.0, 1.0}};
  surrogate::GradientBuffers buffers;
  std::vector<double> gradient(4);
  EXPECT_EQ(surrogate::loss_and_gradient(network, sample.batch(), buffers, gradient), 0.25);
  EXPECT_EQ(gradient, (std::vector<double>{1.5, 1.5, 0.5, 0.0}));
}

TEST(SurrogateGradient, BuffersOfALargerBatchLeaveNoTrace) {
  Network network;
  base::Random random(23);
  surrogate::initialise(network, random);
  for (double& parameter : network.parameters) parameter += 0.1;
  const Sample large = random_sample(random, network, 9), small = random_sample(random, network, 2);
  std::vector<double> fresh(network.parameters.size()), reused(network.parameters.size());
  surrogate::GradientBuffers clean, used;
  surrogate::loss_and_gradient(network, large.batch(), used, reused);
  surrogate::loss_and_gradient(network, small.batch(), used, reused);
  surrogate::loss_and_gradient(network, small.batch(), clean, fresh);
  EXPECT_EQ(reused, fresh);
  EXPECT_EQ(surrogate::mean_squared_error(network, Batch{}), 0.0);
}

}  // namespace
