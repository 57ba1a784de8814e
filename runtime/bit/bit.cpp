#include "runtime/bit/bit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.hpp"
#include "base/units.hpp"

namespace bitrock::runtime {

namespace {

using base::deg, base::mm;

// The rings of a single-set bit cover its face once. Rounding and a missing centre are less than this [1].
constexpr double allowed_width_error = 0.1;

base::Section describe_bit(Bit& bit, BitWords& words) {
  const base::Range diameter = base::between(10.0, 5000.0);  // from a core bit on the bench to a shaft
  const base::Range window = base::between(1.0, 360.0);
  const base::Range factor = base::between(0.01, 2.0);  // pulses without width have no force
  return {
      "bit",
      {{"name", &bit.name, 1.0, base::any(), "for people", true},
       {"diameter_mm", &bit.diameter, mm, diameter, "diameter of the bit", true},
       {"mode", &words.mode, 1.0, base::any(),
        "what the force is rebuilt by: 'sawtooth', 'article', 'article-literal', or 'auto': sawtooth when the model "
        "can, else article"},
       {"window_angle_deg", &bit.signal.window_angle, deg, window, "angle over which peaks are drawn together"},
       {"pulse_width_factor", &bit.signal.pulse_width_factor, 1.0, factor,
        "half-width of a peak over half the mean distance of peaks"},
       {"combine", &words.combine, 1.0, base::any(), "overlapping peaks: 'sum' or 'max'"},
       {"amplitude_fit", &words.amplitude_fit, 1.0, base::any(),
        "how heights meet their mean: 'band_preserving' or 'article'"},
       {"seed", &words.seed, 1.0, base::between(0, 2147483647), "of all random draws"}}};
}

base::Section describe(Cutter& cutter, double bit_diameter) {
  const base::Range width = base::between(0.01, bit_diameter / mm);  // a cutter thinner than any grain cuts nothing
  const base::Range radius = base::between(0.01, 0.5 * bit_diameter / mm);
  return {
      "cutter",
      {{"radius_mm", &cutter.radius, mm, radius,
        "from the axis of the bit to the middle of the ring of rock that this cutter takes", true},
       {"width_mm", &cutter.width, mm, width, "width of that ring; all rings together are the radius of the bit", true},
       {"back_rake_deg", &cutter.back_rake, deg, base::between(0.0, 60.0), "back rake", true}}};
}

void take_words(const base::ConfigFile& file, const BitWords& words, SignalSettings& signal) {
  if (words.combine != "sum" && words.combine != "max") file.refuse("bit", "combine", "must be 'sum' or 'max'");
  if (words.amplitude_fit != "band_preserving" && words.amplitude_fit != "article") {
    file.refuse("bit", "amplitude_fit", "must be 'band_preserving' or 'article'");
  }
  const std::optional<SignalMode> mode = mode_named(words.mode);
  if (!mode) file.refuse("bit", "mode", "must be 'auto', 'sawtooth', 'article' or 'article-literal'");
  signal.mode = *mode;
  signal.combine = words.combine == "max" ? Combine::max : Combine::sum;
  signal.amplitude_fit = words.amplitude_fit == "article" ? AmplitudeFit::article : AmplitudeFit::band_preserving;
  signal.seed = static_cast<std::uint64_t>(words.seed);
}

}  // namespace

Bit bit_inside(base::ConfigFile& file) {
  Bit bit;
  bit.signal.window_angle = default_window_angle_deg * deg;
  BitWords words;
  file.fill(describe_bit(bit, words));
  take_words(file, words, bit.signal);

  const int count = file.count("cutter");
  for (int i = 0; i < count; ++i) {
    Cutter cutter{.number = i + 1};
    file.fill_entry(describe(cutter, bit.diameter), i);
    bit.cutters.push_back(cutter);
  }
  return bit;
}

Bit read_bit(base::ConfigFile& file) {
  Bit bit = bit_inside(file);
  file.refuse_unknown();
  if (bit.cutters.empty()) throw base::InputError(file.name() + ": no [[cutter]] (a bit needs at least one)");
  return bit;
}

std::vector<std::string> warnings(const Bit& bit) {
  std::vector<std::string> found;
  if (bit.cutters.empty()) return found;
  double width = 0.0;
  for (const Cutter& cutter : bit.cutters) width += cutter.width;
  const double share = width / (0.5 * bit.diameter);
  if (std::abs(share - 1.0) > allowed_width_error) {
    found.push_back(fmt::format(
        "bit '{}': the widths of its {} cutters add up to {:.4g} mm, {:.3g} of its radius of {:.4g} mm: each cutter "
        "takes the whole depth of its ring, so {}",
        bit.name, bit.cutters.size(), width / mm, share, 0.5 * bit.diameter / mm,
        share < 1.0 ? "rock is left standing and the force is too small (let the rings meet, their edges half-way "
                      "between neighbouring cutters)"
                    : "some rock is cut twice and the force is too large (width_mm is the width of the ring that a "
                      "cutter takes alone, not that of its face: let the edges of the rings lie half-way between "
                      "neighbouring cutters)"));
  }
  std::map<double, int> first_on;  // the cutter that is first on each circle
  std::string shared;
  for (const Cutter& cutter : bit.cutters) {
    const auto [first, is_new] = first_on.emplace(cutter.radius, cutter.number);
    if (!is_new) shared += fmt::format("{}{} and {}", shared.empty() ? "" : ", ", first->second, cutter.number);
  }
  if (!shared.empty()) {
    found.push_back(fmt::format(
        "bit '{}': cutters run on one circle, and each takes the whole depth there: {} (write the cutters of "
        "a circle as one, with their mean back rake)",
        bit.name, shared));
  }
  return found;
}

Bit read_bit(const std::filesystem::path& path) {
  base::ConfigFile file = base::ConfigFile::read(path);
  return read_bit(file);
}

std::string_view name_of(SignalMode mode) {
  return std::find_if(mode_names.begin(), mode_names.end(), [&](const ModeName& known) { return known.mode == mode; })
      ->name;
}

std::optional<SignalMode> mode_named(std::string_view name) {
  const auto found =
      std::find_if(mode_names.begin(), mode_names.end(), [&](const ModeName& known) { return known.name == name; });
  return found == mode_names.end() ? std::nullopt : std::optional(found->mode);
}

BitWords words_of(const Bit& bit) {
  return {.mode = std::string(name_of(bit.signal.mode)),
          .combine = bit.signal.combine == Combine::max ? "max" : "sum",
          .amplitude_fit = bit.signal.amplitude_fit == AmplitudeFit::article ? "article" : "band_preserving",
          .seed = static_cast<int>(bit.signal.seed)};
}

std::vector<base::Section> describe(Bit& bit, BitWords& words) {
  std::vector<base::Section> sections{describe_bit(bit, words)};
  for (Cutter& cutter : bit.cutters) {
    sections.push_back(describe(cutter, bit.diameter));
    sections.back().name = "[cutter]";  // an array of tables
  }
  return sections;
}

std::vector<base::KeyRow> bit_keys() {
  constexpr double widest_bit = 5.0;  // [m] the ranges of a cutter end with the bit it stands in
  Bit bit{.diameter = widest_bit};
  bit.signal.window_angle = default_window_angle_deg * deg;
  bit.cutters.emplace_back();
  BitWords words;
  return base::key_rows(describe(bit, words));
}

}  // namespace bitrock::runtime
