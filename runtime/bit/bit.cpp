#include "runtime/bit/bit.hpp"

#include "base/errors.hpp"
#include "base/units.hpp"

namespace runtime {

namespace {

using base::deg, base::mm;

base::Section describe_bit(Bit& bit, BitWords& words) {
  const base::Range window = base::between(1.0, 360.0);
  const base::Range factor{.low = 0.0, .high = 2.0, .low_open = true};
  return {"bit",
          {{"name", &bit.name, 1.0, base::any(), "for people", true},
           {"diameter_mm", &bit.diameter, mm, base::between(1.0, 1e4), "diameter of the bit", true},
           {"window_angle_deg", &bit.signal.window_angle, deg, window, "angle over which peaks are drawn together"},
           {"pulse_width_factor", &bit.signal.pulse_width_factor, 1.0, factor,
            "half-width of a peak over half the mean distance of peaks"},
           {"combine", &words.combine, 1.0, base::any(), "overlapping peaks: 'sum' or 'max'"},
           {"amplitude_fit", &words.amplitude_fit, 1.0, base::any(),
            "how heights meet their mean: 'band_preserving' or 'article'"},
           {"seed", &words.seed, 1.0, base::at_least(0.0), "of all random draws"}}};
}

base::Section describe(Cutter& cutter, double bit_diameter) {
  const base::Range width{.low = 0.0, .high = bit_diameter / mm, .low_open = true};
  const base::Range radius{.low = 0.0, .high = 0.5 * bit_diameter / mm, .low_open = true};
  return {"cutter",
          {{"radius_mm", &cutter.radius, mm, radius, "from the axis of the bit to the middle of the cutter", true},
           {"width_mm", &cutter.width, mm, width, "effective width", true},
           {"back_rake_deg", &cutter.back_rake, deg, base::between(0.0, 60.0), "back rake", true}}};
}

void take_words(const base::ConfigFile& file, const BitWords& words, SignalSettings& signal) {
  if (words.combine != "sum" && words.combine != "max") file.refuse("bit", "combine", "must be 'sum' or 'max'");
  if (words.amplitude_fit != "band_preserving" && words.amplitude_fit != "article") {
    file.refuse("bit", "amplitude_fit", "must be 'band_preserving' or 'article'");
  }
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

Bit read_bit(const std::filesystem::path& path) {
  base::ConfigFile file = base::ConfigFile::read(path);
  return read_bit(file);
}

BitWords words_of(const Bit& bit) {
  return {.combine = bit.signal.combine == Combine::max ? "max" : "sum",
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

}  // namespace runtime
