#include "dem2d/specimen/discs_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace dem2d {

namespace {

constexpr std::size_t fewest_discs = 10;

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

Specimen specimen_from_discs(const std::filesystem::path& path, const Rock& rock, std::uint64_t seed,
                             const std::optional<BoxSize>& box) {
  const base::CsvTable table = base::read_csv(path);
  require_values(table, "radius_m", allowed_radius);
  for (const char* column : {"x_m", "y_m"}) require_values(table, column, allowed_place);
  Specimen specimen{.rock = rock, .seed = seed};
  specimen.x = table.column("x_m");
  specimen.y = table.column("y_m");
  specimen.radius = table.column("radius_m");
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

}  // namespace dem2d
