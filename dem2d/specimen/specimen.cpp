#include "dem2d/specimen/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem2d/specimen/pieces.hpp"
#include "dem2d/step/pairs.hpp"

namespace bitrock::dem2d {

namespace {

constexpr int fewest_firm_joints = 3;            // of a disc that is no floater
constexpr std::size_t most_pairs_per_disc = 16;  // three in a plane packing of like discs, six with many small ones

Discs discs_of(const Specimen& specimen) {
  Discs discs;
  discs.x = specimen.x;
  discs.y = specimen.y;
  discs.radius = specimen.radius;
  return discs;
}

// Some floaters in the middle of a packing are as usual; a twentieth of the discs apart is not [1].
constexpr double least_largest_piece = 0.95;

/// Area of the lens shared by two overlapping discs of radius a and b at distance d [m2].
double lens_area(double a, double b, double d) {
  if (d >= a + b) return 0.0;
  if (d <= std::fabs(a - b)) return std::numbers::pi * std::min(a, b) * std::min(a, b);
  const double alpha = std::acos(std::clamp((d * d + a * a - b * b) / (2.0 * d * a), -1.0, 1.0));
  const double beta = std::acos(std::clamp((d * d + b * b - a * a) / (2.0 * d * b), -1.0, 1.0));
  return a * a * (alpha - 0.5 * std::sin(2.0 * alpha)) + b * b * (beta - 0.5 * std::sin(2.0 * beta));
}

}  // namespace

std::optional<Overlap> absurd_overlap(const Specimen& specimen) {
  // only the first pairs where there are more than any packing has: a heap of discs, or radii in a wrong unit, would
  // have one for every two discs
  const Discs discs = discs_of(specimen);
  const Pairs pairs = pairs_within(discs, 0.0, most_pairs_per_disc * discs.x.size());
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(pairs.disc1[k]), j = static_cast<std::size_t>(pairs.disc2[k]);
    const double distance = std::hypot(discs.x[j] - discs.x[i], discs.y[j] - discs.y[i]);
    const double overlap = (discs.radius[i] + discs.radius[j] - distance) / std::min(discs.radius[i], discs.radius[j]);
    if (overlap > largest_overlap) return Overlap{i, j, overlap, distance == 0.0};
  }
  return std::nullopt;
}

void join_neighbours(Specimen& specimen) {
  Pairs pairs = pairs_within(discs_of(specimen), specimen.rock.installation_gap);
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

Pieces pieces(const Specimen& specimen) {
  std::vector<std::size_t> discs;
  for (const int piece : label_pieces(specimen.x.size(), specimen.disc1, specimen.disc2)) {
    const auto place = static_cast<std::size_t>(piece);
    if (place >= discs.size()) discs.resize(place + 1, 0);
    ++discs[place];
  }
  Pieces found{.largest = discs.empty() ? 0 : discs.front()};
  for (const std::size_t size : discs) ++(size == 1 ? found.unjoined : found.count);
  return found;
}

std::vector<std::string> warnings(const Specimen& specimen) {
  const Pieces found = pieces(specimen);
  const auto discs = static_cast<double>(specimen.x.size());
  const double share = static_cast<double>(found.largest) / discs;
  if (specimen.x.empty() || share >= least_largest_piece) return {};
  return {
      fmt::format("the {} discs hang together in {} pieces, the largest has {:.3g} % of them, and {} discs have no "
                  "joint: what is tested or cut is no single block of rock (a larger flat_joints.installation_gap_mm, "
                  "now {:.4g}, joins discs that lie farther apart)",
                  specimen.x.size(), found.count, 100.0 * share, found.unjoined, specimen.rock.installation_gap * 1e3)};
}

}  // namespace bitrock::dem2d
