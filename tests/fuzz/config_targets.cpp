// Input files in TOML.
#include "dem2d/cut/cut_case.hpp"
#include "runtime/bit/bit.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/well/well_case.hpp"
#include "studies/calibrate/target.hpp"
#include "studies/campaign/study.hpp"
#include "tests/fuzz/targets.hpp"

using namespace bitrock;

namespace fuzz {

namespace {

/// As shipped, but beside its rock.
std::string beside_rock(const std::string& file, const std::string& rock) {
  return with(shipped(file), rock, "rock.toml");
}

std::string study_by_table() {
  return "rock = \"rock.toml\"\ntable = \"table.csv\"\nseeds = [1, 2]\n[cut]\ncut_length_mm = 30\n";
}

}  // namespace

std::vector<Target> config_targets() {
  return {
      {.name = "rock_toml",
       .read = [](std::string_view bytes) { dem2d::parse_rock(bytes, "rock.toml"); },
       .seeds = {shipped("campaigns/rocks/article.toml"), shipped("campaigns/rocks/start_granite.toml")}},
      {.name = "cut_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "cut.toml", [](const std::string& path) {
               const dem2d::CutCase cut = dem2d::read_cut_case(path);
               dem2d::warnings(cut);
               dem2d::parse_resolved(dem2d::resolved_toml(cut), "what was resolved");
             });
           },
       .seeds = {beside_rock("campaigns/cuts/example.toml", "../rocks/article.toml"),
                 beside_rock("campaigns/cuts/fine.toml", "../rocks/article_fine.toml")}},
      {.name = "resolved_toml",
       .read = [](std::string_view bytes) { dem2d::parse_resolved(std::string(bytes), "run.h5"); },
       .seeds = {dem2d::resolved_toml(dem2d::read_cut_case(BITROCK_SOURCE_DIR "/campaigns/cuts/example.toml"))}},
      {.name = "study_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "study.toml", [](const std::string& path) {
               const studies::Study study = studies::read_study(path);
               studies::warnings(study);
               studies::resolved_toml(study);
             });
           },
       .seeds = {beside_rock("campaigns/eight.toml", "rocks/article.toml"),
                 beside_rock("campaigns/paper240.toml", "rocks/article_fine.toml"), study_by_table()}},
      {.name = "target_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "target.toml", [](const std::string& path) { studies::read_target(path); });
           },
       .seeds = {beside_rock("campaigns/rocks/targets/article.toml", "../start.toml")}},
      {.name = "bit_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "bit_.toml", [](const std::string& path) { runtime::read_bit(path); });
           },
       .seeds = {shipped("campaigns/bits/pdc15.toml")}},
      {.name = "well_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "well.toml", [](const std::string& path) {
               const runtime::WellCase well = runtime::read_well_case(path);
               if (well.survey_file.empty()) runtime::require_stable(well, runtime::assemble(well));
             });
           },
       .seeds = {with(shipped("campaigns/drill/deviated.toml"), "../bits/pdc15.toml", "bit.toml")}},
      {.name = "drill_toml",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "drill.toml",
                          [](const std::string& path) { runtime::assemble(runtime::read_drill_case(path)); });
           },
       .seeds = {with(shipped("campaigns/drill/normal.toml"), "../bits/pdc15.toml", "bit.toml"),
                 with(shipped("campaigns/drill/stick_slip.toml"), "../bits/pdc15.toml", "bit.toml"),
                 with(shipped("campaigns/drill/bit_bounce.toml"), "../bits/pdc15.toml", "bit.toml")}},
  };
}

}  // namespace fuzz
