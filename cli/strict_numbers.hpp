#pragma once
/// Numbers in flags, read as strictly as those in files (base/number.hpp). The library that reads the flags takes 010
/// for eight, 0x14 for twenty, `nan` for a number inside any range and -1 for the largest unsigned number.

#include <CLI/CLI.hpp>

namespace bitrock::cli {

/// For every flag of the program and its subcommands whose value is a number: only decimal digits are let through, and
/// they reach the library in a form that it reads in the same way. Call when all flags are declared.
void read_numbers_strictly(CLI::App& app);

}  // namespace bitrock::cli
