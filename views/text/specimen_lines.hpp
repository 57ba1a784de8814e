#pragma once
/// What `specimen` tells of a specimen.

#include <string>

#include "dem2d/specimen/summary.hpp"

namespace bitrock::views {

/// Size, discs and joints; how it was packed and hangs together. Ends within a line, for the caller's own last words.
std::string specimen_lines(const dem2d::Specimen& specimen, const dem2d::SpecimenSummary& summary);

}  // namespace bitrock::views
