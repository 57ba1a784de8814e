// bitrock drill survey: a survey of a well, read and checked, and the hole that follows from it.
#include <memory>

#include "cli/drill_parts.hpp"
#include "studies/well/survey.hpp"
#include "views/json/survey_json.hpp"
#include "views/text/survey_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string file;
  studies::SurveyWish wish;
  std::vector<double> tie_in;
};

void show(const Options& options) {
  studies::SurveyWish wish = options.wish;
  if (!options.tie_in.empty()) wish.tie_in = {options.tie_in[0], options.tie_in[1], options.tie_in[2]};
  const studies::WellSurvey survey = studies::read_survey(options.file, wish);
  require_outputs(options.common, {options.file}, {});
  say(options.common, "{}", views::survey_table(options.file, survey));
  warn(options.common, survey.warnings);
  write_json(options.common, views::as_json(survey));
}

}  // namespace

void add_drill_survey(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command = drill.add_subcommand(
      "survey", "Reads a survey of a well and prints where its hole goes: depths, angles, positions, doglegs.");
  command
      ->add_option("survey", options->file,
                   "The survey: a table with a header (commas, tabs or blanks between the columns), a WITSML 1.4.1.1 "
                   "trajectory, or a well trace of Petrel, e.g. campaigns/drill/survey_example.csv.")
      ->required();
  command
      ->add_option("--md-unit", options->wish.units.md, "The depths of a table that does not say it are in this unit.")
      ->check(CLI::IsMember({"m", "ft", "ftUS"}));
  command
      ->add_option("--angle-unit", options->wish.units.angle,
                   "The angles of a table that does not say it are in this unit.")
      ->check(CLI::IsMember({"deg", "rad"}));
  command
      ->add_option(
          "--tie-in-m", options->tie_in,
          "The first station lies this far north, east and down from the rotary table, e.g. 12,-3.5,800: for a "
          "survey that begins below the surface in an inclined hole.")
      ->expected(3)
      ->delimiter(',')
      ->check(within("--tie-in-m", base::between(-1e5, 1e5)));
  command
      ->add_option("--bit-depth-m", options->wish.bit_depth,
                   "The hole goes on straight from the last station to this measured depth.")
      ->check(within("--bit-depth-m", base::between(0.0, 2e4)));
  add_common(*command, options->common);
  command->callback([options] { show(*options); });
}

}  // namespace bitrock::cli
