#pragma once
/// What `signal` and `drill` tell of the force on the bit: how often the networks were asked outside their range, and
/// how many windows could not have what the networks say.

#include "cli/command.hpp"
#include "runtime/bit/bit_force.hpp"

namespace bitrock::cli {

/// What is odd about the bit, and what of its rakes the networks have not learnt.
void warn_of_bit(const CommonOptions& options, const runtime::Bit& bit, const surrogate::Model& model);

/// What the networks were asked outside their range: nothing, a line where it was seldom (less
/// than a tenth of the questions), or else a warning.
/// `asked` says by how much (`runtime::asked_outside`), and at which motion; it may be empty.
void tell_clamps(const CommonOptions& options, const runtime::ClampTally& clamps, const std::string& asked);

/// Windows that could not have what the networks say, and what to do: nothing, a line where they are few (less than a
/// tenth), or else a warning.
void tell_draws(const CommonOptions& options, const runtime::DrawTally& draws);

/// How many windows of the mode "sawtooth" could not have what the networks say; nothing where all could.
void tell_sawtooth_draws(const CommonOptions& options, const runtime::DrawTally& draws);

/// The flag `--mode`; where it is given the bit takes it in place of the mode of its file.
void add_mode(CLI::App& command, std::string& mode);
void take_mode(const std::string& mode, runtime::Bit& bit);

}  // namespace bitrock::cli
