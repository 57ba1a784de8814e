// What the FMU of a bit says of itself.
#include <fmt/format.h>

#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/bit_variables.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/fmu/model_description.hpp"

namespace bitrock::fmu {

namespace {

/// The words of a bit file, in the order of the constants of the runtime.
constexpr const char* lists = R"(    <SimpleType name="Combine"><Enumeration>
      <Item name="sum" value="1"/><Item name="max" value="2"/>
    </Enumeration></SimpleType>
    <SimpleType name="AmplitudeFit"><Enumeration>
      <Item name="band_preserving" value="1"/><Item name="article" value="2"/>
    </Enumeration></SimpleType>
)";
static_assert(BITROCK_COMBINE_SUM + first_item == 1 && BITROCK_COMBINE_MAX + first_item == 2);
static_assert(BITROCK_FIT_BAND_PRESERVING + first_item == 1 && BITROCK_FIT_ARTICLE + first_item == 2);

/// Start value of an input or a parameter.
std::string start_of(unsigned reference, const bitrock_signal& signal) {
  switch (reference) {
    case averaging_time:
      return fmt::format("{}", signal.average_window_s);
    case window_angle:
      return fmt::format("{}", signal.window_angle_rad);
    case pulse_width_factor:
      return fmt::format("{}", signal.pulse_width_factor);
    case seed:
      return fmt::format("{}", signal.seed);
    case combine:
      return fmt::format("{}", signal.combine + first_item);
    case amplitude_fit:
      return fmt::format("{}", signal.amplitude_fit + first_item);
    default:
      return "0";
  }
}

/// Bounds that may be reached.
std::string bounds_of(unsigned reference) {
  switch (reference) {
    case threshold_weight:
    case seed:
    case questions:
    case clamped:
      return " min=\"0\"";
    case pulse_width_factor:
      return " max=\"2\"";
    default:
      return "";
  }
}

}  // namespace

std::string model_description(const runtime::Bit& bit, const surrogate::Model& model, const std::string& guid) {
  const runtime::CoreDescription core = runtime::describe(bit, model);
  ModelDescription description{
      .name = bit.name,
      .about = fmt::format("Force and torque of the rock '{}' on the bit '{}', {} cutters, rebuilt from networks that "
                           "learnt from data of fingerprint {}",
                           model.rock, bit.name, bit.cutters.size(), model.provenance.data_fingerprint),
      .identifier = bit_identifier,
      .guid = guid,
      .lists = lists,
      .stop_time = 10.0,
      .step = 0.0002};  // that of `bitrock signal`: 5000 samples a second
  for (unsigned i = 0; i < bit_variable_count; ++i) {
    description.variables.push_back(described(i, bit_variables[i], start_of(i, core.plain.signal), bounds_of(i)));
    // the angle is 0; all else depends on what is set
    description.variables.back().known_at_start = i == angle;
  }
  return text_of(description);
}

}  // namespace bitrock::fmu
