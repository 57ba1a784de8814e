#pragma once
/// Parts of the case of a short string in a bent hole, for tests that differ in the rest.

#include <string>

namespace well_texts {

/// Keys of [well]: straight for 60 m, then built to 60 degrees.
inline const std::string bent_path = R"(measured_depth_m = [0, 60, 150]
inclination_deg = [0, 0, 60]
azimuth_deg = [0, 20, 20]
)";

/// 95 m of 5 in pipe in an 8 1/2 in hole.
inline const std::string hole_and_pipe = R"([[hole]]
to_depth_m = 150
diameter_mm = 215.9
friction = 0.2
[[pipe]]
length_m = 95
outer_diameter_mm = 127
inner_diameter_mm = 108.61
segment_length_m = 10
)";

/// Turned at 30 rpm, without friction at the bit.
inline const std::string slow_drive = R"([top_drive]
rotation_rpm = 30
ramp_s = 1
[friction]
law = "none"
)";

}  // namespace well_texts
