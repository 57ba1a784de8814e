#pragma once
/// A whole bit as a list of cutters, and its file. A bit here is geometry and the settings of its signal; it has no
/// rock, no mass and no motion.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/config.hpp"
#include "base/config_rows.hpp"
#include "runtime/signal/settings.hpp"

namespace bitrock::runtime {

/// One cutter, and the ring of rock that it takes.
struct Cutter {
  int number = 0;          ///< part of the address of its random draws; 1-based place in the file
  double radius = 0.0;     ///< [m] from the axis to the middle of the ring of rock that it takes
  double width = 0.0;      ///< [m] of that ring: turns force per metre into force
  double back_rake = 0.0;  ///< [rad] tilt of its face against the normal of the rock, positive leaning back
};

/// One cutter a track ("single-set"): each cutter removes the whole advance of one turn on its own ring. The widths
/// then add up to the radius of the bit.
struct Bit {
  std::string name;             ///< for people
  double diameter = 0.0;        ///< [m]
  SignalSettings signal;        ///< how its force is rebuilt
  std::vector<Cutter> cutters;  ///< in the order of the file
};

/// Defaults of the signal. A sixth of a turn is 113 mm of cut at the gauge of a 216 mm bit and some 20 mm near its
/// centre, about the length of a simulated cut; amax grows with that length, so windows should not be far from it.
inline constexpr double default_window_angle_deg = 60.0;

/// Throws `InputError` with file, line and key: no cutter, a radius of 0 or beyond the bit's, a width not above 0, an
/// unknown word or key.
Bit read_bit(base::ConfigFile& file);
/// Throws `InputError` when it is no bit.
Bit read_bit(const std::filesystem::path& path);

/// What is allowed but hardly meant, in words: cutters that leave rock standing between them, or take some of it twice.
std::vector<std::string> warnings(const Bit& bit);

/// The bit of a file in which other things stand too: its keys of `[bit]`, and `[[cutter]]`.
Bit bit_inside(base::ConfigFile& file);

/// The words for the modes, in files and flags.
struct ModeName {
  std::string_view name;  ///< as it is written
  SignalMode mode;        ///< what it means
};
/// All of them, in the order in which people are told.
inline constexpr std::array<ModeName, 4> mode_names{{{"auto", SignalMode::automatic},
                                                     {"sawtooth", SignalMode::sawtooth},
                                                     {"article", SignalMode::article},
                                                     {"article-literal", SignalMode::article_literal}}};

/// The word for it.
std::string_view name_of(SignalMode mode);
/// Empty for a name that no mode has.
std::optional<SignalMode> mode_named(std::string_view name);

/// What the file says in other terms than the bit holds.
struct BitWords {
  std::string mode = "auto";                      ///< "auto", "article", "article-literal" or "sawtooth"
  std::string combine = "sum";                    ///< "sum" or "max"
  std::string amplitude_fit = "band_preserving";  ///< "band_preserving" or "article"
  int seed = 1;                                   ///< of all draws
};
/// The words of the file for what the bit holds.
BitWords words_of(const Bit& bit);

/// `[bit]`, then a `[[cutter]]` each, bound to `bit` and `words` (base/config.hpp).
std::vector<base::Section> describe(Bit& bit, BitWords& words);

/// What people are told of the keys of a bit file.
std::vector<base::KeyRow> bit_keys();

}  // namespace bitrock::runtime
