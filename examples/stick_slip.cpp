// Stick-slip of my string: a drill string of my own on the bit and the rock of a shipped case, turned at three speeds.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=stick_slip && cmake --build
//   build/examples build/examples/stick_slip PREFIX/share/bitrock/campaigns/drill/stick_slip.toml
//
// Prints the lowest natural frequencies, and for each speed how the bit turns: 100 % of the speed up and down and time
// at rest are stick-slip.
#include <cstdio>
#include <exception>
#include <optional>

#include "base/units.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "surrogate/net/model_file.hpp"

using namespace bitrock;

namespace {

void drill_with_my_string(const char* case_file) {
  runtime::DrillCase drill = runtime::read_drill_case(case_file);
  drill.pipes = {
      {.length = 400.0, .outer_diameter = 0.127, .inner_diameter = 0.1086},  // [m] drill pipe, from the top
      {.length = 60.0, .outer_diameter = 0.165, .inner_diameter = 0.0715},   // [m] collars
  };
  drill.torsional_lumps = drill.axial_lumps = 6;
  drill.drive.hook_load = 150e3;  // [N]
  drill.run.duration = 30.0;      // [s]
  drill.run.settling = 10.0;      // [s] that the summary leaves out
  drill.run.step = 5e-5;          // [s]

  const std::optional<surrogate::Model> networks = surrogate::read_model(drill.source.model_file);
  const runtime::DrillString string = runtime::assemble(drill);
  const runtime::DrillModes modes = runtime::drill_modes(string);
  std::printf("weight on bit at rest %.1f kN; torsion %.2f and %.2f Hz, axial %.1f Hz\n",
              runtime::static_weight_on_bit(string) / 1e3, modes.torsional[0], modes.torsional[1], modes.axial[0]);

  std::printf("drive_rpm  lowest_rpm  highest_rpm  severity  at_rest_percent  rop_m_per_h\n");
  for (const double rpm : {30.0, 80.0, 140.0}) {
    drill.drive.rotation = rpm * base::rpm;
    const runtime::DrillSource rock = runtime::make_source(drill, networks);  // anew: a bit remembers where it has been
    const runtime::DrillSummary seen = runtime::run_drill(drill, runtime::assemble(drill), rock).summary;
    std::printf("%9.0f %11.1f %12.1f %9.2f %16.1f %12.2f\n", rpm, seen.bit_rotation.lowest / base::rpm,
                seen.bit_rotation.highest / base::rpm, seen.severity, 100.0 * seen.share_at_rest,
                seen.rop.mean / base::m_per_h);
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 2) return std::fprintf(stderr, "usage: stick_slip CASE.toml\n"), 2;
    drill_with_my_string(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stick_slip: %s\n", error.what());
    return 1;
  }
}
