#pragma once
/// What the subcommands with a bit share: `--mode`, and what is told of the bit and of the force on it.

#include "cli/command.hpp"
#include "views/text/bit_remarks.hpp"

namespace bitrock::cli {

/// What is odd about the bit, and what of its rakes the networks have not learnt.
void warn_of_bit(const CommonOptions& options, const runtime::Bit& bit, const surrogate::Model& model);

/// Each a line or a warning.
void tell(const CommonOptions& options, const std::vector<views::BitRemark>& remarks);

/// The flag `--mode`; where it is given the bit takes it in place of the mode of its file.
void add_mode(CLI::App& command, std::string& mode);
void take_mode(const std::string& mode, runtime::Bit& bit);

}  // namespace bitrock::cli
