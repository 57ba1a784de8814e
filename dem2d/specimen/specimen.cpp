#include "dem2d/specimen/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "dem2d/step/pairs.hpp"

namespace dem2d {

namespace {

constexpr int fewest_firm_joints = 3;  // of a disc that is no floater

/// Area of the lens shared by two overlapping discs of radius a and b at distance d [m2].
double lens_area(double a, double b, double d) {
  if (d >= a + b) return 0.0;
  if (d <= std::fabs(a - b)) return std::numbers::pi * std::min(a, b) * std::min(a, b);
  const double alpha = std::acos(std::clamp((d * d + a * a - b * b) / (2.0 * d * a), -1.0, 1.0));
  const double beta = std::acos(std::clamp((d * d + b * b - a * a) / (2.0 * d * b), -1.0, 1.0));
  return a * a * (alpha - 0.5 * std::sin(2.0 * alpha)) + b * b * (beta - 0.5 * std::sin(2.0 * beta));
}

}  // namespace

void join_neighbours(Specimen& specimen) {
  Discs discs;
  discs.x = specimen.x;
  discs.y = specimen.y;
  discs.radius = specimen.radius;
  Pairs pairs = pairs_within(discs, specimen.rock.installation_gap);
  specimen.disc1 = std::move(pairs.disc1);
  specimen.disc2 = std::move(pairs.disc2);
}

std::string mismatch(const Specimen& kept, const Rock& rock, double width, double height, std::uint64_t seed) {
  constexpr double rounding = 1e-9;  // [m]; 35 times 3 mm is not 105 mm to the last bit
  if (std::fabs(kept.width - width) > rounding || std::fabs(kept.height - height) > rounding) {
    return fmt::format("{:.6g} x {:.6g} mm (wanted is a bed of {:.6g} x {:.6g} mm)", kept.width * 1e3,
                       kept.height * 1e3, width * 1e3, height * 1e3);
  }
  Rock of_kept = kept.rock, wanted = rock;
  if (base::to_toml(describe_material(of_kept)) != base::to_toml(describe_material(wanted))) {
    return "made of another rock than is wanted";
  }
  if (!kept.packed_elsewhere() && kept.seed != seed) {
    return fmt::format("made with seed {} (wanted is {})", kept.seed, seed);
  }
  return "";
}

double porosity(const Specimen& specimen) {
  double covered = 0.0;
  for (const double radius : specimen.radius) covered += std::numbers::pi * radius * radius;
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(specimen.disc1[k]), j = static_cast<std::size_t>(specimen.disc2[k]);
    const double distance = std::hypot(specimen.x[j] - specimen.x[i], specimen.y[j] - specimen.y[i]);
    covered -= lens_area(specimen.radius[i], specimen.radius[j], distance);
  }
  return 1.0 - covered / (specimen.width * specimen.height);
}

double coordination_number(const Specimen& specimen) {
  return 2.0 * static_cast<double>(specimen.disc1.size()) / static_cast<double>(specimen.x.size());
}

int floaters(const Specimen& specimen) {
  std::vector<int> joints(specimen.x.size(), 0);
  for (const int disc : specimen.disc1) ++joints[static_cast<std::size_t>(disc)];
  for (const int disc : specimen.disc2) ++joints[static_cast<std::size_t>(disc)];
  return static_cast<int>(
      std::count_if(joints.begin(), joints.end(), [](int count) { return count < fewest_firm_joints; }));
}

namespace {

/// The disc that stands for the piece of a disc; the paths to it are halved on the way.
std::size_t root_of(std::vector<std::size_t>& parent, std::size_t disc) {
  while (parent[disc] != disc) {
    parent[disc] = parent[parent[disc]];
    disc = parent[disc];
  }
  return disc;
}

}  // namespace

Pieces pieces(const Specimen& specimen) {
  std::vector<std::size_t> parent(specimen.x.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    const std::size_t one = root_of(parent, static_cast<std::size_t>(specimen.disc1[k]));
    const std::size_t other = root_of(parent, static_cast<std::size_t>(specimen.disc2[k]));
    parent[std::max(one, other)] = std::min(one, other);
  }
  std::vector<std::size_t> discs(parent.size(), 0);
  for (std::size_t i = 0; i < parent.size(); ++i) ++discs[root_of(parent, i)];
  Pieces found;
  for (const std::size_t size : discs) {
    if (size == 1) ++found.unjoined;
    if (size > 1) ++found.count;
    if (size > 1) found.largest = std::max(found.largest, size);
  }
  return found;
}

std::string falls_apart(const Specimen& specimen) {
  constexpr double loose_share = 0.05;  // genesis leaves about 1 % of the discs with less than three joints
  const Pieces found = pieces(specimen);
  const auto discs = static_cast<double>(specimen.x.size());
  if (found.count == 1 && static_cast<double>(found.unjoined) <= loose_share * discs) return "";
  return fmt::format(
      "the joints make {} pieces, the largest of {} of {} discs, and leave {} discs without a joint: no "
      "joint holds these together (flat_joints.installation_gap_mm = {:.4g})",
      found.count, found.largest, specimen.x.size(), found.unjoined, specimen.rock.installation_gap * 1e3);
}

}  // namespace dem2d
