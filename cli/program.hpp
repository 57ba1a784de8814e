#pragma once
/// All subcommands and flags of the program, declared in one place: for `main`, which runs them, and for the page of
/// the documentation that lists them.

#include <CLI/CLI.hpp>

namespace bitrock::cli {

void declare_program(CLI::App& app);

}  // namespace bitrock::cli
