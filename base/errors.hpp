#pragma once
/// The ways a bitrock computation can end early, and the exit status each one becomes in `cli/`.
/// Libraries throw these and never print or exit. A message reads: what was seen, (what is allowed), what to try.
/// What was seen may hold any bytes of a user's file: each error makes its message fit to be shown (`base::printable`).

#include <stdexcept>
#include <string>

namespace bitrock::base {

/// The user's input is wrong: a file, a key, a flag. Exit status 2.
struct InputError : std::runtime_error {
  /// The message is for the user: what is wrong, where, what is allowed.
  explicit InputError(const std::string& message);
};

/// The computation failed although the input was acceptable: not a number, no convergence, disk full. Exit status 3.
struct SimulationError : std::runtime_error {
  /// The message says what could not be computed, and why.
  explicit SimulationError(const std::string& message);
};

/// A result could not be written: disk full, folder gone. No further result could be either. Exit status 3.
struct OutputError : SimulationError {
  using SimulationError::SimulationError;
};

/// Whoever read our standard output has closed it (`bitrock ... | head -1`). The program ends without a word, as other
/// tools do. Exit status 141, that of a program that SIGPIPE ends.
struct ReaderGone : std::runtime_error {
  ReaderGone() : std::runtime_error("the reader of standard output is gone") {}
};

/// The user stopped the program (Ctrl-C). Exit status 130, the shell's convention for it.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace bitrock::base
