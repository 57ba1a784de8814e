#pragma once
/// What `signal` and `drill` tell of the force on a bit: how often the networks were asked outside their range, and how
/// many windows could not have what the networks say.

#include <string>
#include <vector>

#include "runtime/bit/bit_force.hpp"

namespace bitrock::views {

/// One line for the user.
struct BitRemark {
  std::string text;
  bool is_warning = false;  ///< otherwise what it speaks of was seldom: less than a tenth
};

/// What the networks were asked outside their range; nothing where all was inside. `asked` says by how much
/// (`runtime::asked_outside`), and at which motion; it may be empty.
std::vector<BitRemark> remarks(const runtime::ClampTally& clamps, const std::string& asked);

/// Windows that could not have what the networks say, and what to do; nothing where all could. `mode` is the one that
/// rebuilt the force, not `automatic`; of the mode "sawtooth" there are no warnings.
std::vector<BitRemark> remarks(const runtime::DrawTally& draws, runtime::SignalMode mode);

}  // namespace bitrock::views
