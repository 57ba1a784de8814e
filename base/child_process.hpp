#pragma once
/// Another program of the system, run to its end. It is started without a shell: arguments reach it as they are,
/// whatever spaces, quotes or signs they hold.

#include <string>
#include <vector>

namespace base {

struct ProgramEnd {
  int status = 0;      ///< exit status, or 128 + the number of the signal that ended it
  std::string output;  ///< what it printed, standard output and error together
};

/// True when the folders of PATH hold an executable of this name.
bool is_installed(const std::string& program);

/// Runs `arguments[0]`, found along PATH, with the other arguments and an empty standard input, and waits for its end.
/// Throws `SimulationError` when it cannot be started and `Interrupted`, after ending it, when the user stops bitrock.
ProgramEnd run_program(const std::vector<std::string>& arguments);

}  // namespace base
