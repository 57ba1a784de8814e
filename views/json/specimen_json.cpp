#include "views/json/specimen_json.hpp"

namespace bitrock::views {

nlohmann::json as_json(const dem2d::Specimen& specimen, const dem2d::SpecimenSummary& summary) {
  nlohmann::json result{{"discs", specimen.x.size()},
                        {"joints", specimen.disc1.size()},
                        {"porosity", summary.porosity},
                        {"coordination_number", summary.coordination_number},
                        {"floaters", summary.floaters},
                        {"pieces", summary.pieces.count},
                        {"discs_of_largest_piece", summary.pieces.largest},
                        {"discs_without_joint", summary.pieces.unjoined},
                        {"equilibrium_ratio", specimen.equilibrium_ratio},
                        {"pressure_Pa", specimen.pressure},
                        {"radius_factor", specimen.radius_factor},
                        {"critical_step_s", summary.critical_step},
                        {"width_m", specimen.width},
                        {"height_m", specimen.height},
                        {"origin", specimen.origin},
                        {"seed", specimen.seed}};
  if (specimen.packed_elsewhere()) {
    for (const char* unknown : {"equilibrium_ratio", "pressure_Pa", "radius_factor"}) result[unknown] = nullptr;
  }
  return result;
}

}  // namespace bitrock::views
