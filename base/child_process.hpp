#pragma once
/// Another program of the system, run to its end. It is started without a shell: arguments reach it as they are,
/// whatever spaces, quotes or signs they hold. That alone does not make a name harmless: gnuplot, ffmpeg and
/// ImageMagick take some names for commands, options or addresses. So no name that a user has given goes into the
/// arguments: the program works in a folder of our own (base/temporary_folder.hpp), on files that bitrock has named.

#include <filesystem>
#include <string>
#include <vector>

namespace bitrock::base {

/// How a program ended that was started.
struct ProgramEnd {
  int status = 0;      ///< exit status, or 128 + the number of the signal that ended it
  std::string output;  ///< what it printed, standard output and error together
};

/// True when the folders of PATH hold an executable of this name.
bool is_installed(const std::string& program);

/// Runs `arguments[0]`, found along PATH, with the other arguments and an empty standard input, and waits for its end.
/// It works in `folder`; where that is empty, in ours. Throws `SimulationError` when it cannot be started and
/// `Interrupted`, after ending it and all that it has started, when the user stops bitrock.
ProgramEnd run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder = {});

/// Ends all programs that run. From then on none can be started: the caller ends bitrock.
void end_programs();

}  // namespace bitrock::base
