// bitrock: from lab rock to the force on a whole bit. Reads flags, runs one subcommand, turns what went wrong into an
// exit status: 0 done, 2 the input is wrong, 3 the computation failed, 130 stopped by Ctrl-C, 141 whoever read our
// output has gone.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>

#include "base/errors.hpp"
#include "base/version.hpp"
#include "base/watch.hpp"
#include "cli/command.hpp"
#include "cli/shipped.hpp"
#include "cli/strict_numbers.hpp"

using namespace bitrock;

namespace {

constexpr int wrong_input = 2, failed = 3, reader_gone = 128 + SIGPIPE;

/// Threads that wait for each other must sleep, not spin: on a machine with other work, spinning threads hold the cores
/// that their partners need, and two threads become forty times slower than one. The OpenMP library reads this choice
/// from the environment when it is loaded, before `main`; so the program sets it and starts itself again, once.
void let_waiting_threads_sleep(char** argv) {
  constexpr int keep_what_the_user_chose = 0;
  if (std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  if (::setenv("OMP_WAIT_POLICY", "passive", keep_what_the_user_chose) != 0) return;
  ::execv("/proc/self/exe", argv);  // returns only when it failed: then go on as we are
}

/// A standard stream that is closed gets a number that nothing else may have: otherwise the first file that is opened
/// would get it, and what is printed would end up there. Printing to it fails, as it would have.
void fill_closed_streams() {
  constexpr int as_if_closed[] = {O_WRONLY, O_RDONLY, O_WRONLY};  // but errors, which go nowhere
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", as_if_closed[stream]);
  }
}

int end_with(const std::string& prefix, const std::exception& error, int status) {
  cli::tell_user(prefix + error.what());
  return status;
}

/// The library's words for --help and for what is wrong with the flags.
int end_with(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream help, complaint;
  const bool good = app.exit(error, help, complaint) == 0;
  if (!help.str().empty()) cli::print(help.str());
  if (!complaint.str().empty()) cli::tell_user(complaint.str().substr(0, complaint.str().find_last_not_of('\n') + 1));
  return good ? 0 : wrong_input;
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return end_with(app, error);
  }
  return 0;
}

}  // namespace

// What is thrown while the flags are declared is a fault of the program, and ends it.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  fill_closed_streams();
  let_waiting_threads_sleep(argv);
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is then an error of its write, like a full disk
  std::signal(SIGPIPE, SIG_IGN);  // and so is a pipe whose reader is gone: nothing half-written stays
  base::Watch watch;

  CLI::App app{
      "bitrock cuts synthetic rock with one PDC cutter, teaches small networks the peaks of the force, and rebuilds "
      "from "
      "them the force on a whole bit."};
  app.name("bitrock");
  app.set_version_flag("--version", std::string("bitrock ") + base::version + " (" + base::git_commit + ")");
  app.require_subcommand(1);
  cli::add_specimen(app);
  cli::add_calibrate(app);
  cli::add_cut(app);
  cli::add_campaign(app);
  cli::add_lab(app);
  cli::add_peaks(app);
  cli::add_train(app);
  cli::add_predict(app);
  cli::add_parity(app);
  cli::add_signal(app);
  cli::add_drill(app);
  cli::add_report(app);
  cli::add_snapshot(app);
  cli::add_animate(app);
  cli::add_export(app);
  cli::let_shipped_files_be_named(app);
  cli::read_numbers_strictly(app);

  try {
    const int status = run(app, argc, argv);
    watch.end();
    return status;
  } catch (const base::InputError& error) {
    watch.end();
    return end_with("", error, wrong_input);
  } catch (const base::Interrupted& error) {
    watch.end();
    return end_with("", error, base::interrupted);
  } catch (const base::ReaderGone&) {
    return reader_gone;
  } catch (const base::SimulationError& error) {
    watch.end();
    return end_with("the computation failed: ", error, failed);
  } catch (const std::bad_alloc&) {
    watch.end();
    cli::tell_user("the computation failed: not enough memory (fewer discs or samples need less)");
    return failed;
  } catch (const std::exception& error) {
    watch.end();
    return end_with("the computation failed: ", error, failed);
  }
}
