#pragma once
/// Cuts small enough for tests.

#include <string>

#include "dem2d/cut/cut_case.hpp"

using namespace bitrock;

namespace small_cuts {

/// The example cut at 2 m/s in grains of 0.8 mm on average. The test sizes it.
inline dem2d::CutCase fine_grained() {
  dem2d::CutCase cut = dem2d::read_cut_case(std::string(BITROCK_SOURCE_DIR) + "/campaigns/cuts/example.toml");
  cut.rock.radius_min = 0.32e-3;
  cut.rock.radius_max = 0.48e-3;
  cut.rock.installation_gap = 0.032e-3;
  cut.cutter_speed = 2.0;
  return cut;
}

}  // namespace small_cuts
