#include "views/text/specimen_lines.hpp"

#include <fmt/format.h>

namespace bitrock::views {

std::string specimen_lines(const dem2d::Specimen& specimen, const dem2d::SpecimenSummary& summary) {
  const std::string packed =
      specimen.packed_elsewhere()
          ? specimen.origin
          : fmt::format("packed under {:.4g} MPa (equilibrium ratio {:.2g}, radii x {:.4f})", specimen.pressure * 1e-6,
                        specimen.equilibrium_ratio, specimen.radius_factor);
  const dem2d::Pieces& pieces = summary.pieces;
  return fmt::format(
      "{}: {:.4g} x {:.4g} mm, {} discs, {} joints, coordination {:.2f}, porosity {:.3f}\n"
      "{}, {} piece{} joined, {} floaters (less than 3 joints), critical step {:.3g} s",
      specimen.rock.name, specimen.width * 1e3, specimen.height * 1e3, specimen.x.size(), specimen.disc1.size(),
      summary.coordination_number, summary.porosity, packed, pieces.count, pieces.count == 1 ? "" : "s",
      summary.floaters, summary.critical_step);
}

}  // namespace bitrock::views
