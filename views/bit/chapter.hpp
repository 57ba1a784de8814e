#pragma once
/// The chapter of a report about the force on a whole bit.

#include <filesystem>

#include "report/page.hpp"

namespace bitrock::views {

/// `csv` as written by `bitrock signal`; `json` its result, or empty.
void add_bit_force(report::Page& page, const std::filesystem::path& csv, const std::filesystem::path& json);

}  // namespace bitrock::views
