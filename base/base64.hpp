#pragma once
/// Bytes as printable text, for pages and files that must be text.

#include <string>
#include <string_view>

namespace bitrock::base {

/// Base64 with padding, without line breaks [Rfc4648, sec. 4].
std::string base64(std::string_view bytes);

}  // namespace bitrock::base
