#pragma once
/// JSON from outside, read with the care that the library leaves to others: a key twice in one object (the library
/// silently takes the last), numbers beyond a double, texts that are cut short, in another encoding or nested without
/// end are refused with file and place.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace bitrock::base {

/// Throws `InputError`. `file` is the name for messages.
nlohmann::json json_from_text(std::string_view text, const std::string& file);

}  // namespace bitrock::base
