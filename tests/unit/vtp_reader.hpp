#pragma once
/// Files for ParaView, read back by hand: each array is found at its offset and is as long as it says.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace vtp_reader {

/// Base64 back to bytes, up to its padding or the first character that is none of its digits.
inline std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;
    word = word << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(word >> (bits -= 8) & 255u);
  }
  return bytes;
}

inline std::string between(const std::string& text, const std::string& before, const std::string& after,
                           std::size_t from = 0) {
  const std::size_t begin = text.find(before, from);
  if (begin == std::string::npos) return "";
  const std::size_t start = begin + before.size();
  return text.substr(start, text.find(after, start) - start);
}

/// The values of the array of this name and type; fails the test when its length is not the one in front of it.
template <class T>
std::vector<T> array(const std::string& vtp, const std::string& type, const std::string& name) {
  const std::string element = between(vtp, "<DataArray type=\"" + type + "\" Name=\"" + name + "\"", "/>");
  EXPECT_FALSE(element.empty()) << name;
  const std::string block = between(vtp, "<AppendedData encoding=\"base64\">_", "<");
  const std::string bytes = decoded(block.substr(std::stoul(between(element, "offset=\"", "\""))));
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  // every array ends in the padding of its base64 or exactly: the decoder stopped there or runs into the next one
  EXPECT_LE(sizeof length + length, bytes.size()) << name;
  EXPECT_EQ(length % sizeof(T), 0u);
  std::vector<T> values(length / sizeof(T));
  if (length > 0) std::memcpy(values.data(), bytes.data() + sizeof length, length);
  return values;
}
inline std::vector<double> reals(const std::string& vtp, const std::string& name) {
  return array<double>(vtp, "Float64", name);
}
inline std::vector<int> integers(const std::string& vtp, const std::string& name) {
  return array<int>(vtp, "Int32", name);
}

}  // namespace vtp_reader
