#include "views/text/signal_lines.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace bitrock::views {

std::string signal_lines(const runtime::Bit& bit, const runtime::ConstantSpeed& drive,
                         const runtime::SignalSummary& summary) {
  return fmt::format(
      "{}: {:g} rpm, {:g} m/h, depth of cut {:.4g} mm per turn\n"
      "axial force mean {:.4g} kN, max {:.4g} kN; torque mean {:.4g} N m, max {:.4g} N m\n",
      bit.name, base::in_units(drive.rotation, base::rpm), base::in_units(drive.rate_of_penetration, base::m_per_h),
      summary.depth_of_cut_m * 1e3, summary.mean_force_N * 1e-3, summary.max_force_N * 1e-3, summary.mean_torque_N_m,
      summary.max_torque_N_m);
}

}  // namespace bitrock::views
