#pragma once
/// The ways a bitrock computation can end early, and the exit status each one becomes in `cli/`.
/// Libraries throw these and never print or exit. A message reads: what was seen, (what is allowed), what to try.

#include <stdexcept>

namespace base {

/// The user's input is wrong: a file, a key, a flag. Exit status 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation failed although the input was acceptable: not a number, no convergence, disk full. Exit status 3.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A result could not be written: disk full, folder gone. No further result could be either. Exit status 3.
struct OutputError : SimulationError {
  using SimulationError::SimulationError;
};

/// The user stopped the program (Ctrl-C). Exit status 130, the shell's convention for it.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace base
