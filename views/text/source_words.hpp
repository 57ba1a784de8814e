#pragma once
/// What shakes the bit of a run, in a few words.

#include <string>

#include "runtime/drillstring/drill_case.hpp"

namespace bitrock::views {

/// `model`: fingerprint of the networks.
std::string source_words(const runtime::SourceCase& source, const std::string& model);

}  // namespace bitrock::views
