#include "base/oilfield_key.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "base/units.hpp"

namespace bitrock::base {

namespace {

struct Partner {
  std::string_view ending, other;
  double si_per_unit;  ///< of the other
};

// No ending is the end of another one that stands below it.
constexpr std::array partners{
    Partner{"_kg_per_m3", "_ppg", ppg},  Partner{"_kg_per_m", "_lb_per_ft", lb_per_ft},
    Partner{"_kN_m", "_ft_lbf", ft_lbf}, Partner{"_N_m", "_ft_lbf", ft_lbf},
    Partner{"_kN", "_klbf", klbf},       Partner{"_MPa", "_psi", psi},
    Partner{"_mm2", "_in2", inch* inch}, Partner{"_mm", "_in", inch},
    Partner{"_m", "_ft", foot},
};

const Partner& partner_of(const std::string& key) {
  const auto fits = [&key](const Partner& partner) { return key.ends_with(partner.ending); };
  const auto found = std::find_if(partners.begin(), partners.end(), fits);
  const bool slope = key.find("_per_") != std::string::npos && found != partners.end() &&
                     found->ending.find("_per_") == std::string_view::npos;  // N_per_m is no length
  if (found == partners.end() || slope) throw std::logic_error("the key " + key + " has no unit of the oil field");
  return *found;
}

}  // namespace

std::optional<Field> in_oilfield_unit(const Field& field) {
  if (!field.oilfield) return std::nullopt;
  const Partner& partner = partner_of(field.name);
  Field other = field;
  other.name = field.name.substr(0, field.name.size() - partner.ending.size()) + std::string(partner.other);
  other.si_per_unit = partner.si_per_unit;
  other.range.low = in_units(field.range.low * field.si_per_unit, partner.si_per_unit);
  other.range.high = in_units(field.range.high * field.si_per_unit, partner.si_per_unit);
  return other;
}

std::vector<Section> also_in_oilfield_units(std::vector<Section> sections, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    bool found = false;
    for (Section& section : sections) {
      for (Field& field : section.fields) {
        if (field.name != key) continue;
        found = field.oilfield = true;
        in_oilfield_unit(field);  // throws where there is none
      }
    }
    if (!found) throw std::logic_error("no section has the key " + key);
  }
  return sections;
}

}  // namespace bitrock::base
