#include "runtime/drillstring/modes.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace bitrock::runtime {

namespace {

Eigen::MatrixXd pair_matrix(const std::vector<double>& between, const std::vector<double>& to_ground, double at_bit) {
  const Eigen::Index n = static_cast<Eigen::Index>(between.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    matrix(i, i) += between[k] + (to_ground.empty() ? 0.0 : to_ground[k]);
    if (i == 0) continue;
    matrix(i - 1, i - 1) += between[k];
    matrix(i - 1, i) -= between[k];
    matrix(i, i - 1) -= between[k];
  }
  matrix(n - 1, n - 1) += at_bit;
  return matrix;
}

Eigen::MatrixXd mass_matrix(const Chain& chain) {
  return Eigen::Map<const Eigen::VectorXd>(chain.inertia.data(), static_cast<Eigen::Index>(chain.size()))
      .asDiagonal()
      .toDenseMatrix();
}

using Solver = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>;

/// Spectral radius of one step h of the solver on positions q, h v and h^2 a. With D = 1/M:
///   u = h v + h^2 a / 2,  q' = q + u,  h^2 a' = -h^2 D K q' - h D C (h v + h^2 a),  h v' = u + h^2 a' / 2.
double spectral_radius(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping, double h) {
  const Eigen::Index n = stiffness.rows();
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n), zero = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXd drift(n, 3 * n), predicted(n, 3 * n), kicked(n, 3 * n);
  kicked << zero, one, 0.5 * one;
  drift << one, one, 0.5 * one;
  predicted << zero, one, one;
  const Eigen::MatrixXd kick = -h * h * stiffness * drift - h * damping * predicted;
  Eigen::MatrixXd step(3 * n, 3 * n);
  step << drift, kicked + 0.5 * kick, kick;
  return Eigen::EigenSolver<Eigen::MatrixXd>(step, false).eigenvalues().cwiseAbs().maxCoeff();
}

/// Stiffness and damping matrices times the inverse of the mass.
struct ScaledChain {
  Eigen::MatrixXd stiffness, damping;
};

ScaledChain scaled_by_mass(const Chain& chain, const BitSupport& support) {
  const Eigen::MatrixXd inverse = mass_matrix(chain).inverse();
  return {.stiffness = inverse * pair_matrix(chain.stiffness, {}, support.stiffness),
          .damping = inverse * pair_matrix(chain.damping, chain.wall_damping, support.damping)};
}

/// Free motion has a double eigenvalue of 1, which rounding moves by the square root of its own size.
bool is_bounded(const ScaledChain& scaled, double h) {
  return spectral_radius(scaled.stiffness, scaled.damping, h) <= 1.0 + 1e-6;
}

}  // namespace

std::vector<double> natural_frequencies(const Chain& chain, const BitSupport& support) {
  // a chain has three diagonals; scaled by the roots of its masses it is symmetric
  const Eigen::Index n = static_cast<Eigen::Index>(chain.size());
  Eigen::VectorXd diagonal(n), beside(n - 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double below = i + 1 < n ? chain.stiffness[k + 1] : support.stiffness;
    diagonal(i) = (chain.stiffness[k] + below) / chain.inertia[k];
    if (i + 1 < n) beside(i) = -below / std::sqrt(chain.inertia[k] * chain.inertia[k + 1]);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  const double rounding = 1e-13 * solver.eigenvalues().maxCoeff();  // of a free chain's 0
  std::vector<double> frequencies;
  for (const double square : solver.eigenvalues())
    frequencies.push_back(square > rounding ? std::sqrt(square) / (2.0 * std::numbers::pi) : 0.0);
  return frequencies;
}

double equivalent_damping(const Chain& chain) {
  const Solver solver(pair_matrix(chain.stiffness, {}, 0.0), mass_matrix(chain));
  const Eigen::VectorXd mode = solver.eigenvectors().col(0);
  const double at_bit = mode(mode.size() - 1);
  return mode.dot(pair_matrix(chain.damping, chain.wall_damping, 0.0) * mode) / (at_bit * at_bit);
}

double damping_margin(const Chain& chain) {
  const Eigen::Index n = static_cast<Eigen::Index>(chain.size());
  const Eigen::MatrixXd inverse = mass_matrix(chain).inverse();
  const Eigen::MatrixXd stiffness = inverse * pair_matrix(chain.stiffness, {}, 0.0);
  const auto grows = [&](double taken) {
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    motion.topRightCorner(n, n).setIdentity();
    motion.bottomLeftCorner(n, n) = -stiffness;
    motion.bottomRightCorner(n, n) = -inverse * pair_matrix(chain.damping, chain.wall_damping, -taken);
    return Eigen::EigenSolver<Eigen::MatrixXd>(motion, false).eigenvalues().real().maxCoeff() > 1e-9;
  };
  double low = 0.0, high = 1e-3;
  while (!grows(high)) {
    low = high;
    high *= 2.0;
  }
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

double continuous_frequency(double wave_speed, double length, int k) {
  return (2.0 * k - 1.0) * wave_speed / (4.0 * length);
}

double hung_frequency(double wave_speed, double length, double stiffness_ratio) {
  double low = 0.0, high = 0.5 * std::numbers::pi;
  for (int halving = 0; halving < 60; ++halving) {
    const double x = 0.5 * (low + high);
    (x * std::sin(x) < stiffness_ratio * std::cos(x) ? low : high) = x;
  }
  return low * wave_speed / (2.0 * std::numbers::pi * length);
}

double equal_lumps_frequency(double stiffness, double inertia, int lumps, int k) {
  return std::sqrt(stiffness / inertia) / std::numbers::pi *
         std::sin((2.0 * k - 1.0) * std::numbers::pi / (2.0 * (2.0 * lumps + 1.0)));
}

double longest_stable_step(const Chain& chain, const BitSupport& support) {
  constexpr double shortest = 1e-12, longest = 1e3;
  const ScaledChain scaled = scaled_by_mass(chain, support);
  const double norm = scaled.stiffness.norm();
  double stable = norm > 0.0 ? 2.0 / std::sqrt(norm) : 1.0;
  while (!is_bounded(scaled, stable)) {
    stable *= 0.5;
    if (stable < shortest) return 0.0;
  }
  double unstable = 2.0 * stable;
  while (is_bounded(scaled, unstable)) {
    stable = unstable;
    unstable *= 2.0;
    if (unstable > longest) return longest;
  }
  while (unstable - stable > 1e-3 * stable) {
    const double middle = 0.5 * (stable + unstable);
    (is_bounded(scaled, middle) ? stable : unstable) = middle;
  }
  return stable;
}

bool is_stable_step(const Chain& chain, const BitSupport& support, double h) {
  return is_bounded(scaled_by_mass(chain, support), h);
}

}  // namespace bitrock::runtime
