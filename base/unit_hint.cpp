#include "base/unit_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.hpp"

namespace bitrock::base {

namespace {

struct OtherUnit {
  const char* name;
  double factor;  ///< number in the key's unit = number in this unit * factor
};

/// A unit that keys end in, and the ones it is taken for.
struct KeyUnit {
  std::string_view ending;
  std::array<OtherUnit, 3> others;  ///< unused ones have no name
};

constexpr double inch_in_mm = inch / mm;

// The longest ending counts: `_N_per_m` is no length.
constexpr std::array key_units{
    KeyUnit{"_MPa", {{{"kPa", 1e-3}, {"Pa", 1e-6}, {"GPa", 1e3}}}},
    KeyUnit{"_GPa", {{{"MPa", 1e-3}, {"kPa", 1e-6}, {"Pa", 1e-9}}}},
    KeyUnit{"_um", {{{"mm", 1e3}, {"m", 1e6}, {}}}},
    KeyUnit{"_mm", {{{"um", 1e-3}, {"m", 1e3}, {"inch", inch_in_mm}}}},
    KeyUnit{"_m", {{{"mm", 1e-3}, {"km", 1e3}, {}}}},
    KeyUnit{"_mm2", {{{"m2", 1e6}, {}, {}}}},
    KeyUnit{"_kN", {{{"N", 1e-3}, {}, {}}}},
    KeyUnit{"_kN_m", {{{"N m", 1e-3}, {}, {}}}},
    KeyUnit{"_kg_per_m3", {{{"g/cm3", 1e3}, {}, {}}}},
    KeyUnit{"_m_per_s", {{{"mm/s", 1e-3}, {}, {}}}},
    KeyUnit{"_m_per_h", {{{"m/s", 3600.0}, {}, {}}}},
    KeyUnit{"_ft", {{{"m", 1.0 / foot}, {}, {}}}},
    KeyUnit{"_in", {{{"mm", mm / inch}, {"m", 1.0 / inch}, {}}}},
    KeyUnit{"_klbf", {{{"lbf", 1e-3}, {}, {}}}},
    KeyUnit{"_ppg", {{{"kg/m3", 1.0 / ppg}, {}, {}}}},
    KeyUnit{"_per_s", {}},
    KeyUnit{"_per_ft", {}},
    KeyUnit{"_per_m", {}},
    KeyUnit{"_N_m", {}},
};

// A number that is out of range by less than this factor is more likely wrong than in another metric unit, the least of
// which differ by a thousand [1].
constexpr double slightly = 1.25;

bool slightly_outside(double value, const Range& allowed) {
  return value > 0.0 && value <= slightly * allowed.high && value * slightly >= allowed.low;
}

/// How far from the middle of the range on a logarithmic scale; one that begins at 0 has its middle at its highest.
double off_the_middle(double value, const Range& allowed) {
  const double middle = allowed.low > 0.0 ? std::sqrt(allowed.low * allowed.high) : allowed.high;
  return std::abs(std::log(value / middle));
}

const KeyUnit* unit_of(std::string_view key) {
  const KeyUnit* found = nullptr;
  for (const KeyUnit& unit : key_units) {
    if (key.ends_with(unit.ending) && (found == nullptr || unit.ending.size() > found->ending.size())) found = &unit;
  }
  return found;
}

}  // namespace

std::string unit_hint(std::string_view key, double value, const Range& allowed) {
  std::string written(key);
  std::replace(written.begin(), written.end(), '-', '_');  // flags: --width-mm
  const KeyUnit* unit = unit_of(written);
  if (unit == nullptr) return "";
  const OtherUnit* best = nullptr;
  for (const OtherUnit& other : unit->others) {
    if (other.name == nullptr || !(value > 0.0) || !allowed.contains(value * other.factor)) continue;
    const bool metric = other.factor != inch_in_mm;
    if (metric && slightly_outside(value, allowed)) continue;
    if (best == nullptr ||
        off_the_middle(value * other.factor, allowed) < off_the_middle(value * best->factor, allowed))
      best = &other;
  }
  return best == nullptr ? "" : fmt::format("is it in {}? Then write {:.6g}", best->name, value * best->factor);
}

std::string out_of_range(std::string_view key, double value, const Range& allowed) {
  const std::string hint = unit_hint(key, value, allowed);
  return "must be " + allowed.text() + (hint.empty() ? "" : "; " + hint);
}

}  // namespace bitrock::base
