#include "dem2d/files/discs_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace bitrock::dem2d {

namespace {

constexpr std::size_t fewest_discs = 10;
// Radii over those of the rock, or the other way round [1]. Joints were calibrated with the rock's own; beyond a factor
// of three they hardly fit, which is worth a warning. Beyond twenty the numbers are in another unit: the nearest one
// that people use, the inch, makes a factor of 39.
constexpr double odd_radius_factor = 3.0;
constexpr double wrong_radius_factor = 20.0;

struct Bounds {
  double x_low, y_low, x_high, y_high;
};

Bounds bounds(const Specimen& discs) {
  Bounds b{discs.x[0], discs.y[0], discs.x[0], discs.y[0]};
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    b.x_low = std::min(b.x_low, discs.x[i] - discs.radius[i]);
    b.y_low = std::min(b.y_low, discs.y[i] - discs.radius[i]);
    b.x_high = std::max(b.x_high, discs.x[i] + discs.radius[i]);
    b.y_high = std::max(b.y_high, discs.y[i] + discs.radius[i]);
  }
  return b;
}

void shift_to_own_box(Specimen& discs) {
  const Bounds b = bounds(discs);
  for (double& x : discs.x) x -= b.x_low;
  for (double& y : discs.y) y -= b.y_low;
  discs.width = b.x_high - b.x_low;
  discs.height = b.y_high - b.y_low;
}

void require_inside(const Specimen& discs, const base::CsvTable& table) {
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const double x = discs.x[i], y = discs.y[i];
    if (x >= 0.0 && x <= discs.width && y >= 0.0 && y <= discs.height) continue;
    throw base::InputError(fmt::format(
        "{}:{}: the disc at ({:.6g}, {:.6g}) m lies outside the box of {:.6g} x {:.6g} mm (its lower left corner is at "
        "(0, 0); without a given width and height the box is fitted to the discs)",
        table.source, table.lines[i], x, y, discs.width * 1e3, discs.height * 1e3));
  }
}

void refuse_absurd_overlaps(const Specimen& specimen, const base::CsvTable& table) {
  const std::optional<Overlap> found = absurd_overlap(specimen);
  if (!found) return;
  const int first = table.lines[found->disc1], second = table.lines[found->disc2];
  if (found->same_centre) {
    throw base::InputError(
        fmt::format("{}: the discs of lines {} and {} have the same centre", table.source, first, second));
  }
  throw base::InputError(
      fmt::format("{}: the discs of lines {} and {} overlap by {:.3g} of the smaller radius (at most {} is allowed)",
                  table.source, first, second, found->share, largest_overlap));
}

void require_values(const base::CsvTable& table, const std::string& column, const base::Range& allowed) {
  const std::vector<double>& values = table.column(column);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (allowed.contains(values[i])) continue;
    throw base::InputError(fmt::format("{}:{}: {} = {:.6g} (must be {})", table.source, table.lines[i], column,
                                       values[i], allowed.text()));
  }
}

/// A unit that people write lengths in, beside the metre.
struct Unit {
  const char* name;
  double metres;
};
constexpr Unit other_units[]{{"millimetres", 1e-3}, {"centimetres", 1e-2}, {"inches", 25.4e-3}, {"kilometres", 1e3}};

/// Median radius over the nearest radius that the rock file allows; 1 within its range.
double times_rock_radius(const Specimen& discs) {
  std::vector<double> radii = discs.radius;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  const Rock& rock = discs.rock;
  const double largest = rock.radius_max * (rock.fine_depth > 0.0 ? rock.coarse_ratio : 1.0);
  if (*middle > largest) return *middle / largest;
  return *middle < rock.radius_min ? *middle / rock.radius_min : 1.0;
}

/// In which unit such radii would be those of the rock, as a question; empty when in none.
std::string likely_unit(double times) {
  std::string likely;
  double least = std::log(odd_radius_factor);
  for (const Unit& unit : other_units) {
    const double off = std::abs(std::log(times * unit.metres));
    if (off >= least) continue;
    least = off;
    likely = fmt::format(": are they in {}?", unit.name);
  }
  return likely;
}

/// The radii of the table count, and may be those of another rock, but not those of another unit.
void refuse_another_unit(const Specimen& discs, const base::CsvTable& table) {
  const auto [smallest, largest] = std::minmax_element(discs.radius.begin(), discs.radius.end());
  if (*smallest <= 0.0) return;  // has a message of its own
  const double times = times_rock_radius(discs);
  if (times < wrong_radius_factor && times > 1.0 / wrong_radius_factor) return;
  throw base::InputError(fmt::format(
      "{}: radius_m from {:.4g} to {:.4g} m, {:.3g} times the radii of the rock ([discs] {:.4g} to {:.4g} mm){} (x_m, "
      "y_m and radius_m are in metres; radii may be up to {:g} times larger or smaller than those of the rock)",
      table.source, *smallest, *largest, times, discs.rock.radius_min * 1e3, discs.rock.radius_max * 1e3,
      likely_unit(times), wrong_radius_factor));
}

void require_gap_below_radii(const Specimen& discs, const base::CsvTable& table) {
  const double smallest = *std::min_element(discs.radius.begin(), discs.radius.end());
  if (discs.rock.installation_gap > smallest) {
    throw base::InputError(fmt::format(
        "{}: the smallest radius is {:.4g} mm, less than flat_joints.installation_gap_mm = {:.4g} of the rock (only "
        "neighbours are joined)",
        table.source, smallest * 1e3, discs.rock.installation_gap * 1e3));
  }
}

}  // namespace

std::vector<std::string> discs_warnings(const Specimen& specimen) {
  const double times = times_rock_radius(specimen);
  if (times <= odd_radius_factor && times >= 1.0 / odd_radius_factor) return {};
  return {
      fmt::format("the median radius of the discs is {:.3g} times the nearest radius of the rock file ([discs], {:.4g} "
                  "to {:.4g} mm): moduli and strengths of its joints were found for those",
                  times, specimen.rock.radius_min * 1e3, specimen.rock.radius_max * 1e3)};
}

Specimen specimen_from_discs(const std::filesystem::path& path, const Rock& rock, std::uint64_t seed,
                             const std::optional<BoxSize>& box) {
  const base::CsvTable table = base::read_csv(path);
  table.require({"x_m", "y_m", "radius_m"});
  Specimen specimen{.rock = rock, .seed = seed};
  specimen.x = table.column("x_m");
  specimen.y = table.column("y_m");
  specimen.radius = table.column("radius_m");
  refuse_another_unit(specimen, table);
  require_values(table, "radius_m", allowed_radius);
  for (const char* column : {"x_m", "y_m"}) require_values(table, column, allowed_place);
  specimen.origin =
      fmt::format("discs {} ({})", path.filename().string(), base::fingerprint_text(base::read_whole(path)));
  if (table.rows() < fewest_discs) {
    throw base::InputError(
        fmt::format("{}: {} discs (at least {} are needed)", table.source, table.rows(), fewest_discs));
  }
  require_gap_below_radii(specimen, table);
  if (box) {
    specimen.width = box->width;
    specimen.height = box->height;
    require_inside(specimen, table);
  } else {
    shift_to_own_box(specimen);
  }
  refuse_absurd_overlaps(specimen, table);
  join_neighbours(specimen);
  if (specimen.disc1.empty()) {
    throw base::InputError(fmt::format(
        "{}: no two discs are closer than flat_joints.installation_gap_mm = {:.4g} (nothing would be joined)",
        table.source, rock.installation_gap * 1e3));
  }
  return specimen;
}

}  // namespace bitrock::dem2d
