#include "surrogate/export/columns.hpp"

#include "surrogate/net/further_inputs.hpp"

namespace bitrock::surrogate {

namespace {

struct Words {
  const char* name;
  const char* unit;
  const char* meaning;
};

/// In the order of `input_names`, whose `si_per_unit` leads to these units.
constexpr std::array<Words, input_count> condition_words{{
    {"cutter_speed_m_per_s", "m/s", "along the rock surface"},
    {"depth_of_cut_m", "m", "below the rock surface"},
    {"back_rake_rad", "rad", "lean of the face of the cutter"},
}};

/// Of the five statistics of one force component. Their units are SI in the model file too.
constexpr std::array<const char*, statistics_count> statistic_meanings{
    "height of the highest peak", "mean height of all peaks", "peaks above 75 % of the highest",
    "peaks of 25 % to 75 % of the highest", "peaks below 25 % of the highest"};

/// Of the seven behind these.
constexpr std::array<const char*, moment_count> moment_meanings{
    "mean of the force over the travel",
    "standard deviation of the force over the travel",
    "mean of the force over the travel",
    "standard deviation of the force over the travel",
    "lag at which the autocorrelation over travel has fallen to 1/e",
    "lag at which the autocorrelation over travel has fallen to 3/4",
    "correlation of the two components"};

}  // namespace

std::array<Column, input_count> condition_columns(const Model& model) {
  require_no_further_inputs(model, "the model");
  std::array<Column, input_count> columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double si_per_unit = input_names[i].si_per_unit;
    columns[i] = {.name = condition_words[i].name,
                  .unit = condition_words[i].unit,
                  .meaning = condition_words[i].meaning,
                  .low = model.inputs[i].low * si_per_unit,
                  .high = model.inputs[i].high * si_per_unit};
  }
  return columns;
}

std::vector<Column> statistic_columns(const Model& model) {
  std::vector<Column> columns(model.outputs.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double si_per_unit = output_names[i].si_per_unit;
    const Variable& variable = model.outputs[i].variable;
    columns[i] = {.name = std::string(output_names[i].name),
                  .unit = std::string(output_names[i].unit),
                  .meaning = i < article_output_count ? statistic_meanings[i % statistics_count]
                                                      : moment_meanings[i - article_output_count],
                  .low = variable.low * si_per_unit,
                  .high = variable.high * si_per_unit};
  }
  return columns;
}

}  // namespace bitrock::surrogate
