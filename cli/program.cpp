#include "cli/program.hpp"

#include <string>

#include "base/version.hpp"
#include "cli/command.hpp"
#include "cli/shipped.hpp"
#include "cli/strict_numbers.hpp"

namespace bitrock::cli {

void declare_program(CLI::App& app) {
  app.description(
      "bitrock cuts synthetic rock with one PDC cutter, teaches small networks the peaks of the force, and rebuilds "
      "from them the force on a whole bit.");
  app.name("bitrock");
  app.set_version_flag("--version", std::string("bitrock ") + base::version + " (" + base::git_commit + ")",
                       "The program prints its version, and stops.");
  app.set_help_flag("-h,--help", "The program prints this help, and stops.");
  app.require_subcommand(1);
  add_specimen(app);
  add_calibrate(app);
  add_cut(app);
  add_campaign(app);
  add_lab(app);
  add_peaks(app);
  add_train(app);
  add_predict(app);
  add_hold(app);
  add_learn(app);
  add_parity(app);
  add_rebuild(app);
  add_signal(app);
  add_drill(app);
  add_report(app);
  add_snapshot(app);
  add_animate(app);
  add_export(app);
  let_shipped_files_be_named(app);
  read_numbers_strictly(app);
}

}  // namespace bitrock::cli
