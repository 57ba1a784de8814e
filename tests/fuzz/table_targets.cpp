// Tables, the model file, and ranges in flags.
#include "base/csv.hpp"
#include "base/value_lists.hpp"
#include "dem2d/files/discs_file.hpp"
#include "peaks/parts.hpp"
#include "peaks/statistics.hpp"
#include "studies/calibrate/journal.hpp"
#include "studies/campaign/accepted.hpp"
#include "studies/campaign/features.hpp"
#include "studies/well/survey.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data.hpp"
#include "tests/fuzz/targets.hpp"

using namespace bitrock;

namespace fuzz {

namespace {

/// The header and the first rows.
std::string head_of(const std::string& text, int lines) {
  std::size_t end = 0;
  for (int line = 0; line < lines; ++line) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

std::string square_of_discs() {
  std::string table = "x_m,y_m,radius_m\n";
  for (int k = 0; k < 16; ++k) {
    table += std::to_string(1e-3 * (k % 4)) + "," + std::to_string(1e-3 * (k / 4)) + ",0.0005\n";
  }
  return table;
}

std::string journal() {
  return "inputs,test,confining_pressure_Pa,seed,effective_modulus_Pa,stiffness_ratio,tensile_strength_Pa,cohesion_Pa,"
         "friction,friction_angle_rad,peak_stress_Pa,youngs_modulus_Pa,poissons_ratio,wall_s\n"
         "4503599627370495,0,0,1,1.4e9,3.5,12e6,60e6,0.577,0.2,7e7,1.5e9,0.23,2\n";
}

studies::FeatureRow a_row(int seed) {
  return {.case_number = 1,
          .seed = seed,
          .cutter_speed = 0.5,
          .depth_of_cut = 2e-3,
          .back_rake = 0.35,
          .cut_length = 0.05,
          .duration = 0.1,
          .x = {.amax = 2e5, .amean = 5e4, .np1 = 3, .np23 = 20, .np4 = 40},
          .y = {.amax = 1e5, .amean = 3e4, .np1 = 4, .np23 = 19, .np4 = 38},
          .mean_force_x = 2.5e4,
          .mean_force_y = 1.3e4,
          .sd_x = 3e4,
          .sd_y = 1.7e4,
          .correlation_length = 4e-4,
          .short_correlation_length = 1.5e-4,
          .xy_correlation = 0.9,
          .chips = 15,
          .cracks_tensile = 900,
          .cracks_shear = 20,
          .discs = 1596,
          .step = 1.8e-7,
          .core_time = 42.0,
          .sampling = 20e-6,
          .definition = peaks::converging(0.5e-3),
          .hash = "d9a1d7e96dd519d9"};
}

}  // namespace

std::vector<Target> table_targets() {
  return {
      {.name = "csv",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "any.csv", [](const std::string& path) {
               base::read_csv(path, true, {"hash"});
               base::read_csv(path);
             });
           },
       .seeds = {"a,b\n1,2\n# comment\n3,-4e5\n"}},
      {.name = "history_csv",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "history.csv", [](const std::string& path) {
               const base::CsvTable table = base::read_csv(path, true);
               for (const std::vector<double>& column : table.columns) peaks::peak_statistics(column);
             });
           },
       .seeds = {"time_s,force_N\n0,0\n0.1,5\n0.2,1\n0.3,7\n0.4,nan\n0.5,0\n"}},
      {.name = "features_csv",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "features.csv", [](const std::string& path) { studies::read_features(path); });
           },
       .seeds = {studies::features_csv({a_row(1), a_row(2)})}},
      {.name = "training_csv",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "training.csv",
                          [](const std::string& path) { surrogate::averaged(surrogate::read_training_data(path)); });
           },
       .seeds = {head_of(shipped("campaigns/paper240/features.csv"), 8),
                 head_of(shipped("campaigns/paper240/features_mean.csv"), 4)}},
      {.name = "discs_csv",
       .read =
           [](std::string_view bytes) {
             static const dem2d::Rock rock;
             read_as_file(bytes, "discs.csv", [](const std::string& path) {
               dem2d::specimen_from_discs(path, rock, 1);
               dem2d::specimen_from_discs(path, rock, 1, dem2d::BoxSize{10e-3, 10e-3});
             });
           },
       .seeds = {square_of_discs()}},
      {.name = "journal_csv",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "rock.toml.journal.csv",
                          [](const std::string& path) { studies::Journal(path, "inputs of a test"); });
           },
       .seeds = {journal()}},
      {.name = "survey",
       .read =
           [](std::string_view bytes) {
             read_as_file(bytes, "survey.csv",
                          [](const std::string& path) { studies::survey_points(studies::read_survey(path)); });
           },
       .seeds =
           {shipped("campaigns/drill/survey_example.csv"), "MD\tINC\tAZI\n(ft)\t(deg)\t(deg)\n0\t0\t0\n100\t3\t350\n",
            "MD [m] Incl [deg] Azim [deg] TVD [m]\n10 1 0 10\n100 3 20 99.9\n",
            "<trajectorys version=\"1.4.1.1\"><trajectory><trajectoryStation><md uom=\"m\">0</md><incl "
            "uom=\"dega\">0</incl>"
            "<azi uom=\"dega\">0</azi></trajectoryStation><trajectoryStation><md uom=\"m\">30</md><tvd "
            "uom=\"m\">30</tvd><incl uom=\"dega\">3</incl><azi uom=\"dega\">10</azi></trajectoryStation></trajectory>"
            "</trajectorys>"}},
      {.name = "model_json",
       .read =
           [](std::string_view bytes) {
             const surrogate::Model model = surrogate::model_from_text(bytes, "model.json");
             surrogate::model_from_text(surrogate::model_text(model), "what was written");
             surrogate::predict(model, {});
           },
       .seeds = {shipped("campaigns/paper240/model.json")}},
      {.name = "ranges",
       .read = [](std::string_view bytes) { base::value_range("--flag", std::string(bytes), 0.0, 1e6); },
       .seeds = {"0.5:38:12", "7.5"}},
      {.name = "seeds",
       .read = [](std::string_view bytes) { base::seeds_text(base::seeds_in("--seeds", std::string(bytes))); },
       .seeds = {"7", "1,2,5:10"}},
  };
}

}  // namespace fuzz
