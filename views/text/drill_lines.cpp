#include "views/text/drill_lines.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

std::string line(const char* name, const char* unit, const runtime::Spread& spread, double factor) {
  return fmt::format("{:22} mean {:10.4g}  min {:10.4g}  max {:10.4g} {}\n", name, spread.mean / factor,
                     spread.lowest / factor, spread.highest / factor, unit);
}

}  // namespace

std::string drill_lines(const runtime::DrillCase& drill, const runtime::DrillRun& run) {
  const runtime::DrillSummary& s = run.summary;
  return fmt::format("{}: {:g} s in {} steps of {:.3g} ms\n", drill.name, drill.run.duration, run.steps,
                     run.step * 1e3) +
         line("bit rotation", "rpm", s.bit_rotation, base::rpm) + line("weight on bit", "kN", s.weight_on_bit, 1e3) +
         line("rock on bit in all", "kN", s.total_force, 1e3) + line("torque on bit", "N m", s.torque, 1.0) +
         line("rate of penetration", "m/h", s.rop, 1.0 / 3600.0) +
         (s.hook_load ? line("hook load", "kN", *s.hook_load, 1e3) : "") +
         fmt::format(
             "static weight on bit {:.4g} kN; stick-slip severity {:.3g}; bit at rest {:.3g} %, backwards {:.3g} %, "
             "off bottom {:.3g} % of the time; drilled {:.4g} mm\nenergy lost by the solver {:.2g} %",
             s.static_weight_on_bit * 1e-3, s.severity, 100.0 * s.share_at_rest, 100.0 * s.share_backwards,
             100.0 * s.share_off_bottom, s.drilled * 1e3, 100.0 * s.energy_residual);
}

}  // namespace bitrock::views
