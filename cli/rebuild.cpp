// bitrock rebuild: the force of cuts beside the force that the runtime rebuilds from their statistics.
#include "studies/rebuild/rebuild.hpp"

#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/command.hpp"
#include "runtime/bit/bit.hpp"
#include "surrogate/net/model_file.hpp"
#include "views/json/rebuild_json.hpp"
#include "views/rebuild/chapter.hpp"
#include "views/text/rebuild_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> inputs, modes{"sawtooth"};
  std::string model_file, report_file;
  studies::RebuildOptions rebuild;
};

void run(Options options) {
  options.rebuild.modes.clear();
  for (const std::string& name : options.modes) options.rebuild.modes.push_back(*runtime::mode_named(name));
  options.rebuild.jobs = options.common.threads;
  std::vector<studies::KnownCase> known;
  for (const std::string& input : options.inputs) {
    for (studies::KnownCase& one : studies::read_known_cuts(input)) known.push_back(std::move(one));
  }
  refuse_named_twice(options.inputs);
  std::optional<surrogate::Model> model;
  if (!options.model_file.empty()) model = surrogate::read_model(options.model_file);
  std::vector<std::filesystem::path> inputs(options.inputs.begin(), options.inputs.end()), outputs;
  if (model) inputs.emplace_back(options.model_file);
  if (!options.report_file.empty()) outputs.emplace_back(options.report_file);
  require_outputs(options.common, inputs, outputs);

  const surrogate::Model* const networks = model ? &*model : nullptr;
  Progress progress(options.common, "rebuild", "cases");
  const studies::Rebuilding found = studies::rebuild(std::move(known), networks, options.rebuild, progress.callback());
  warn(options.common, found.left_out);
  if (model) warn(options.common, studies::warnings(found, options.rebuild, *model, options.model_file));
  if (found.known.empty()) throw base::InputError("no case has a force that could be rebuilt");
  say(options.common, "{}", views::rebuild_table(found, options.rebuild));
  if (!options.report_file.empty()) {
    report::Page page("Rebuilt force against DEM");
    page.section("The force that a drill string gets");
    views::add_rebuild(page, found, networks, options.rebuild);
    base::write_whole(options.report_file, page.html());
    say(options.common, "-> {}\n", options.report_file);
  }
  write_json(options.common, views::as_json(found, options.rebuild));
}

}  // namespace

void add_rebuild(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "rebuild", "Holds the force that the runtime rebuilds from a few statistics against the force of the cuts.");
  command
      ->add_option("input", options->inputs,
                   "The cuts: a run.h5, a forces.h5, or a folder that holds one or runs. There may be several.")
      ->required();
  command
      ->add_option("--model", options->model_file,
                   "The force is also rebuilt from what these networks (model.json) say of the conditions of each cut.")
      ->check(not_empty());
  command
      ->add_option("--mode", options->modes,
                   "The force is rebuilt in this mode: sawtooth, article, or article-literal. The flag may stand "
                   "several times.")
      ->check(CLI::IsMember({"sawtooth", "article", "article-literal"}))
      ->default_str("sawtooth");
  command
      ->add_option(
          "--draws", options->rebuild.draws,
          "So many pieces of force, each as long as the cut, are rebuilt for each case. The more, the less the "
          "result depends on chance.")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--seed", options->rebuild.seed, "The seed of all random draws.")->capture_default_str();
  command->add_option("--report", options->report_file, "The comparison goes to this page (.html).")
      ->check(not_empty());
  add_jobs(*command, options->common.threads, "cases are rebuilt");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
