#pragma once
/// Bit, signal and model as one block of bytes: the file `resources/bit.block` of an FMU. Made of 64-bit words, lowest
/// byte first, so that it can be read in place, without a parser, without the heap and on any system. Written by
/// fmu_file.cpp, read inside the FMU's library.
///
// clang-format off
///     words      what
///     4          magic, format version, size [bytes], checksum: `base::fingerprint` of all that follows it
///     5          guid of the FMU: characters, then zeros
///     9          window angle [rad], pulse width factor, averaging time [s], threshold weight [N], combine,
///                amplitude fit, seed, drop length [m], mode
///     1 + 4 n    number of cutters n; for each: radius [m], width [m], back rake [rad], number
///     3 x 4      inputs of the model: low, high, offset, scale
///     1          number of outputs m
///     m x        outputs: offset, scale, log_reference, activation, layer count, layers, then weights and biases
// clang-format on
///
/// Symbols as in `bitrock_runtime.h`. A whole number is a word of its own; a real one is a double.

#include <array>
#include <cstdint>

#include "runtime/core/bitrock_runtime.h"

namespace bitrock::fmu {

inline constexpr std::uint64_t block_magic = 0x6b636f6c42746942ULL;  ///< "BitBlock"
inline constexpr std::uint64_t block_version = 3;                    ///< of the bytes
inline constexpr std::size_t block_checked_from = 32;                ///< [bytes]
inline constexpr std::size_t guid_bytes = 40;                        ///< with at least one 0 at the end

/// What a block says. Points into its bytes; so it must not be copied away from them, nor moved itself.
struct BitBlock {
  std::uint64_t checksum = 0;                             ///< of all behind it
  std::array<char, guid_bytes> guid{};                    ///< of the FMU, as its model description says it; ends with 0
  double threshold_weight = 0.0;                          ///< [N]
  bitrock_description description{};                      ///< points into the bytes
  std::array<std::array<std::int32_t, 16>, 17> layers{};  ///< of each output
};

/// Reads `bytes`, on an address divisible by 8. Null when they are whole and describe a core that can be made;
/// otherwise the reason, in English.
const char* read_bit_block(const void* bytes, std::size_t size, BitBlock& block);

}  // namespace bitrock::fmu
