// bitrock: from lab rock to the force on a whole bit. Reads flags, runs one subcommand, turns what went wrong into an
// exit status: 0 done, 2 the input is wrong, 3 the computation failed, 130 stopped by Ctrl-C.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "base/version.hpp"
#include "cli/command.hpp"
#include "cli/shipped.hpp"
#include "cli/strict_numbers.hpp"

namespace {

constexpr int wrong_input = 2, failed = 3, interrupted = 130;

/// The first signal asks politely, between two steps; the second ends the program at once.
extern "C" void on_stop_signal(int signal) {
  if (base::stop_requested().exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

/// Threads that wait for each other must sleep, not spin: on a machine with other work, spinning threads hold the cores
/// that their partners need, and two threads become forty times slower than one. The OpenMP library reads this choice
/// from the environment when it is loaded, before `main`; so the program sets it and starts itself again, once.
void let_waiting_threads_sleep(char** argv) {
  constexpr int keep_what_the_user_chose = 0;
  if (std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  if (::setenv("OMP_WAIT_POLICY", "passive", keep_what_the_user_chose) != 0) return;
  ::execv("/proc/self/exe", argv);  // returns only when it failed: then go on as we are
}

int report(const char* prefix, const std::exception& error, int status) {
  std::fflush(stdout);
  std::fprintf(stderr, "bitrock: %s%s\n", prefix, error.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  let_waiting_threads_sleep(argv);
  std::signal(SIGINT, on_stop_signal);
  std::signal(SIGTERM, on_stop_signal);
  std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is then an error of its write, like a full disk

  CLI::App app{
      "bitrock: synthetic rock, cut by one PDC cutter, learnt by small networks, rebuilt as the force on a whole bit"};
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
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : wrong_input;
  } catch (const base::InputError& error) {
    return report("", error, wrong_input);
  } catch (const base::Interrupted& error) {
    return report("", error, interrupted);
  } catch (const base::SimulationError& error) {
    return report("the computation failed: ", error, failed);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "bitrock: the computation failed: not enough memory (fewer discs or samples need less)\n");
    return failed;
  } catch (const std::exception& error) {
    return report("the computation failed: ", error, failed);
  }
  return std::fflush(stdout) == 0 ? 0 : failed;
}
