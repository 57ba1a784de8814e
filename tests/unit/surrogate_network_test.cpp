// Forward pass against nets computed by hand, layout of the flat vector, random start.
#include "surrogate/net/network.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "surrogate/net/layers.hpp"

using namespace bitrock;

namespace {

using surrogate::Network;

double output_of(const Network& network, std::vector<double> input) {
  double output = -1.0;
  surrogate::forward(network, input, {&output, 1});
  return output;
}

TEST(SurrogateNetwork, ForwardPassAgreesWithAHandComputedNet) {
  // W1 = [1 -2; 0.5 1; -1 -1], b1 = [0.5 -1 2], W2 = [2 3 -1], b2 = [-0.5].
  const Network network{.layers = {2, 3, 1}, .parameters = {1, -2, 0.5, 1, -1, -1, 0.5, -1, 2, 2, 3, -1, -0.5}};
  // (3, 1): z1 = (1.5, 1.5, -2), a1 = (1.5, 1.5, 0), z2 = 3 + 4.5 - 0 - 0.5 = 7.
  EXPECT_EQ(output_of(network, {3, 1}), 7.0);
  // (0, 0): z1 = (0.5, -1, 2), a1 = (0.5, 0, 2), z2 = 1 + 0 - 2 - 0.5 = -1.5, off.
  EXPECT_EQ(output_of(network, {0, 0}), 0.0);
  // (2, 0.25): z1 = (2, 0.25, -0.25), a1 = (2, 0.25, 0), z2 = 4 + 0.75 - 0.5 = 4.25.
  EXPECT_EQ(output_of(network, {2, 0.25}), 4.25);
}

TEST(SurrogateNetwork, LayersLieInTheFlatVectorRowByRowThenBiases) {
  Network network{.layers = {3, 4, 6, 3, 1}, .parameters = {}};
  ASSERT_EQ(surrogate::parameter_count(network.layers), 71u);  // (3+1)4 + (4+1)6 + (6+1)3 + (3+1)1
  for (int i = 0; i < 71; ++i) network.parameters.push_back(i);
  EXPECT_EQ(surrogate::layer_offset(network.layers, 1), 0u);
  EXPECT_EQ(surrogate::layer_offset(network.layers, 2), 16u);
  EXPECT_EQ(surrogate::layer_offset(network.layers, 3), 46u);
  EXPECT_EQ(surrogate::layer_offset(network.layers, 4), 67u);
  const surrogate::Layer second = surrogate::layer(network, 2);
  EXPECT_EQ(second.weights.rows(), 6);
  EXPECT_EQ(second.weights.cols(), 4);
  EXPECT_EQ(second.weights(1, 2), 16 + 4 + 2);
  EXPECT_EQ(second.biases(5), 16 + 24 + 5);
}

TEST(SurrogateNetwork, ForwardPassAgreesWithMatrixArithmetic) {
  Network network{.layers = {3, 64, 5, 1}, .parameters = {}};
  base::Random random(3);
  surrogate::initialise(network, random);
  int on = 0;
  for (int sample = 0; sample < 50; ++sample) {
    Eigen::VectorXd a(3);
    for (double& value : a) value = base::uniform(random);
    const double seen = output_of(network, {a(0), a(1), a(2)});
    for (int k = 1; k <= 3; ++k) {
      const surrogate::Layer layer = surrogate::layer(network, k);
      a = (layer.weights * a + layer.biases).cwiseMax(0.0).eval();
    }
    EXPECT_NEAR(seen, a(0), 1e-13);
    if (seen > 0.0) ++on;
  }
  EXPECT_GT(on, 0);
}

TEST(SurrogateNetwork, NotANumberShowsInTheOutput) {
  const Network network{.layers = {1, 1}, .parameters = {1.0, 0.0}};
  EXPECT_TRUE(std::isnan(output_of(network, {std::numeric_limits<double>::quiet_NaN()})));
}

TEST(SurrogateNetwork, RandomStartHasTheVarianceOfHeAndZeroBiases) {
  Network network{.layers = {32, 64, 64, 1}, .parameters = {}};
  base::Random random(5);
  surrogate::initialise(network, random);
  for (int k = 1; k <= 2; ++k) {
    const surrogate::Layer layer = surrogate::layer(network, k);
    EXPECT_TRUE(layer.biases.isZero(0.0));
    const auto count = static_cast<double>(layer.weights.size());
    const double variance = layer.weights.squaredNorm() / count;
    const double expected = 2.0 / static_cast<double>(layer.weights.cols());
    // A sum of n squared normals scatters by sqrt(2 n); four of these are allowed.
    EXPECT_NEAR(variance / expected, 1.0, 4.0 * std::sqrt(2.0 / count));
    EXPECT_NEAR(layer.weights.mean(), 0.0, 4.0 * std::sqrt(expected / count));
  }
}

TEST(SurrogateNetwork, TheSameStreamGivesTheSameStart) {
  Network one, two, other;
  base::Random a(9), b(9), c(10);
  surrogate::initialise(one, a);
  surrogate::initialise(two, b);
  surrogate::initialise(other, c);
  EXPECT_EQ(one.parameters, two.parameters);
  EXPECT_NE(one.parameters, other.parameters);
}

TEST(SurrogateNetwork, LayersOutOfRangeAreRefused) {
  EXPECT_EQ(surrogate::layers_problem(std::vector<int>{3, 1}), "");
  EXPECT_EQ(surrogate::layers_problem(std::vector<int>{3}), "1 layers (2 to 16 are allowed)");
  EXPECT_EQ(surrogate::layers_problem(std::vector<int>(17, 3)), "17 layers (2 to 16 are allowed)");
  EXPECT_EQ(surrogate::layers_problem(std::vector<int>{3, 0, 1}), "a layer of 0 nodes (1 to 64 are allowed)");
  EXPECT_EQ(surrogate::layers_problem(std::vector<int>{3, 65, 1}), "a layer of 65 nodes (1 to 64 are allowed)");
  Network network{.layers = {3, 65, 1}, .parameters = {}};
  base::Random random(1);
  EXPECT_THROW(surrogate::initialise(network, random), base::InputError);
}

TEST(SurrogateNetwork, OutputActivationsHaveTheirValuesAndSlopes) {
  using enum surrogate::OutputActivation;
  using surrogate::activated;
  using surrogate::activation_slope;
  EXPECT_EQ(activated(rectified, -2.0), 0.0);
  EXPECT_EQ(activated(rectified, 2.0), 2.0);
  EXPECT_EQ(activated(linear, -2.0), -2.0);
  EXPECT_DOUBLE_EQ(activated(softplus, 0.0), std::log(2.0));
  EXPECT_DOUBLE_EQ(activated(softplus, 1.0), std::log1p(std::exp(1.0)));
  EXPECT_EQ(activated(softplus, 800.0), 800.0);  // where e^z overflows
  EXPECT_EQ(activated(softplus, -800.0), 0.0);
  EXPECT_EQ(activation_slope(rectified, 2.0), 1.0);
  EXPECT_EQ(activation_slope(rectified, 0.0), 0.0);
  EXPECT_EQ(activation_slope(linear, -2.0), 1.0);
  for (const double z : {-3.0, 0.0, 0.7, 30.0}) {
    EXPECT_NEAR(activation_slope(softplus, activated(softplus, z)), 1.0 / (1.0 + std::exp(-z)), 1e-15);
  }
  for (const auto activation : {rectified, softplus, linear}) {
    EXPECT_TRUE(std::isnan(activated(activation, std::nan(""))));
    EXPECT_EQ(surrogate::output_activation(surrogate::name_of(activation)), activation);
  }
  EXPECT_FALSE(surrogate::output_activation("tanh").has_value());
}

TEST(SurrogateNetwork, OnlyTheLastLayerIsOfAnotherKind) {
  // Hidden unit off: relu(-1) = 0, so the output is its bias; a linear hidden unit would give -1 + -3.
  const Network network{
      .layers = {1, 1, 1}, .output = surrogate::OutputActivation::linear, .parameters = {1.0, 0.0, 1.0, -3.0}};
  double output = 0.0;
  surrogate::forward(network, std::vector<double>{-1.0}, {&output, 1});
  EXPECT_EQ(output, -3.0);
}

}  // namespace
