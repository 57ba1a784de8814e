#pragma once
/// What `rebuild` tells: how near the rebuilt forces come to the DEM's, over all cases.

#include <string>

#include "studies/rebuild/rebuild.hpp"

namespace bitrock::views {

/// "the cuts' own statistics, mode sawtooth".
std::string way_in_words(bool from_model, runtime::SignalMode mode);

/// A row a measure and component, for each way of rebuilding that was taken.
std::string rebuild_table(const studies::Rebuilding& rebuilding, const studies::RebuildOptions& options);

}  // namespace bitrock::views
