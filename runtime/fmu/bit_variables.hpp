#pragma once
/// The variables of the FMU of a bit: one table that the model description is written from and the library answers by.

#include <array>

#include "runtime/fmu/variable.hpp"

namespace bitrock::fmu {

/// Numbers of the variables: their places in `bit_variables`, which says unit and meaning of each.
enum BitReference : unsigned {
  rotation,             ///< input [rad/s]
  rate_of_penetration,  ///< input [m/s]
  weight_on_bit,        ///< input [N]
  torque,               ///< output [N m]
  axial_force,          ///< output [N]
  angle,                ///< output [rad]
  depth_of_cut,         ///< output [m]
  questions,            ///< output [1]
  clamped,              ///< output [1]
  threshold_weight,     ///< parameter [N]
  averaging_time,       ///< parameter [s]
  window_angle,         ///< parameter [rad]
  pulse_width_factor,   ///< parameter [1]
  seed,                 ///< parameter [1]
  combine,              ///< parameter, a word of `Combine`
  amplitude_fit,        ///< parameter, a word of `AmplitudeFit`
  bit_variable_count    ///< how many there are
};

/// In the order of their numbers.
inline constexpr std::array<Variable, bit_variable_count> bit_variables{{
    {"rotation_rad_per_s", Causality::input, Type::real, "rad/s",
     "rotation of the bit, positive in the direction of drilling; it cuts only while this is above 0"},
    {"rate_of_penetration_m_per_s", Causality::input, Type::real, "m/s", "of the bit into the rock"},
    {"weight_on_bit_N", Causality::input, Type::real, "N",
     "push of the bit on the rock; it cuts only while this is above the threshold"},
    {"torque_N_m", Causality::output, Type::real, "N.m", "of the rock on the bit, positive against its rotation"},
    {"axial_force_N", Causality::output, Type::real, "N", "of the rock on the bit, positive out of the rock"},
    {"angle_rad", Causality::output, Type::real, "rad", "turned forward while cutting, since the start"},
    {"depth_of_cut_m", Causality::output, Type::real, "m",
     "per turn, from the averaged inputs, before it is moved to the training range of the networks"},
    {"questions", Causality::output, Type::integer, "", "asked of the networks: one for each cutter and window"},
    {"clamped_conditions", Causality::output, Type::integer, "",
     "speeds, depths and rakes of these questions that were moved to the edge of the training range"},
    {"threshold_weight_N", Causality::parameter, Type::real, "N", "weight that does not yet cut, 0 or more"},
    {"averaging_time_s", Causality::parameter, Type::real, "s",
     "of rotation and rate of penetration before they choose the cutting conditions, above 0"},
    {"window_angle_rad", Causality::parameter, Type::real, "rad", "angle over which peaks are drawn together"},
    {"pulse_width_factor", Causality::parameter, Type::real, "",
     "half-width of a peak over half the mean distance of peaks, above 0 and at most 2"},
    {"seed", Causality::parameter, Type::integer, "", "of all draws, 0 or more: give each bit its own"},
    {"combine", Causality::parameter, Type::enumeration, "", "what overlapping peaks do", "Combine"},
    {"amplitude_fit", Causality::parameter, Type::enumeration, "", "how heights meet their mean", "AmplitudeFit"},
}};

inline constexpr const char* bit_identifier = "bitrock_bit";  ///< name of the libraries inside
inline constexpr const char* bit_block_file = "bit.block";    ///< in the folder `resources`

}  // namespace bitrock::fmu
