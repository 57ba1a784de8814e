#pragma once
/// A drill string as one block of bytes: the file `resources/string.block` of an FMU. Made of 64-bit words (words.hpp).
/// Written by string_file.cpp, read inside the FMU's library.
///
// clang-format off
///     words      what
///     4          magic, format version, size [bytes], checksum: `base::fingerprint` of all that follows it
///     5          guid of the FMU: characters, then zeros
///     many       `StringContent`, in the order of `pass`
///     1          size of a bit block [bytes]; 0 without networks
///     many       that block (bit_block.hpp)
// clang-format on
///
/// A string in a well is written as it hangs at rest, so that the library need not find that again.

#include "runtime/fmu/bit_block.hpp"
#include "runtime/fmu/string_words.hpp"

namespace bitrock::fmu {

inline constexpr std::uint64_t string_block_magic = 0x6b6c42676e727453ULL;  ///< "StrngBlk"
inline constexpr std::uint64_t string_block_version = 2;                    ///< of the bytes

/// A case that is ready to be run.
struct StringContent {
  bool in_well = false;                             ///< otherwise in two dimensions
  double step = 0.0;                                ///< [s] of the string
  runtime::SourceCase source;                       ///< what shakes the bit; the seed is the one that is meant
  runtime::DrillString plane;                       ///< in two dimensions; empty in a well
  bool turning = true;                              ///< in two dimensions: begins at the speed of the drive
  double off_bottom = 0.0;                          ///< [m] in two dimensions: lift of the bit at the beginning
  runtime::WellString well;                         ///< in a well; empty in two dimensions
  runtime::WellStringState at_rest;                 ///< its beginning
  runtime::RigPlan plan;                            ///< what the rig does if the host leaves it to it
  std::vector<runtime::StressPoint> stress_points;  ///< without their names
  double fluid_density = 0.0;                       ///< [kg/m^3] of the mud
};

/// All of it.
template <class Io>
void pass(Io& io, StringContent& content) {
  auto& [in_well, step, source, plane, turning, off_bottom, well, at_rest, plan, points, density] = content;
  auto& [kind, force, torque, waves, piece, seed, model] = source;
  pass_all(io, in_well, step, kind, force, torque, waves, piece, seed);
  pass_all(io, plane, turning, off_bottom, well, at_rest, plan, points, density);
}

/// What a block says. The bit points into its bytes; so it must not be moved.
struct StringBlock {
  std::uint64_t checksum = 0;           ///< of all behind it
  std::array<char, guid_bytes> guid{};  ///< of the FMU; ends with 0
  StringContent content;                ///< the case
  BitBlock bit;                         ///< of the source `bit`
};

/// Whether an average is one that samples can leave behind.
bool is_average(const runtime::MovingAverage& average);

/// Whether a state has the room and the places in the hole that the steps of this string go by.
bool is_state_of(const runtime::WellString& well, const runtime::WellStringState& state);

/// Reads `bytes`, on an address divisible by 8. Null when they are whole; otherwise the reason, in English. What a file
/// says of the physics was checked when it was written.
const char* read_string_block(const void* bytes, std::size_t size, StringBlock& block);

}  // namespace bitrock::fmu
