#include "views/bit/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "base/statistics.hpp"

namespace bitrock::views {

namespace {

// The end of the bit's history is shown again, stretched, so that single peaks can be seen [s].
constexpr double closer_look_s = 0.25;

/// Says how many answers of the networks came from the edge of their training range, and why.
void add_clamp_note(report::Page& page, const nlohmann::json& signal) {
  if (!signal.contains("clamped") || !signal["clamped"].is_object()) return;
  std::string reasons;
  for (const char* reason : {"speed_below", "speed_above", "depth_below", "depth_above", "rake_below", "rake_above"}) {
    const long long count = signal["clamped"].value(reason, 0LL);
    if (count == 0) continue;
    std::string words = reason;
    words[words.find('_')] = ' ';
    reasons += fmt::format("{}{} the range {} times", reasons.empty() ? "" : ", ", words, count);
  }
  if (reasons.empty()) return;
  page.note(fmt::format(
      "The networks were asked {} times, some of them outside their training range ({}). There the answer is that of "
      "the nearest edge.",
      signal["clamped"].value("asked", 0LL), reasons));
}

}  // namespace

void add_bit_force(report::Page& page, const std::filesystem::path& csv, const std::filesystem::path& json) {
  const base::CsvTable table = base::read_csv(csv);
  table.require({"time_s", "axial_force_N", "torque_N_m"});
  const std::vector<double>& time = table.column("time_s");
  std::vector<double> force = table.column("axial_force_N");
  const std::vector<double>& torque = table.column("torque_N_m");
  for (double& value : force) value *= 1e-3;

  std::string what = "whole bit";
  if (!json.empty() && base::is_there(json)) {
    try {
      const nlohmann::json result = base::json_from_text(base::read_whole(json), json.string());
      what = fmt::format("{}, {:g} rpm, {:g} m/h ({:.3g} mm per turn)", result.at("bit").get<std::string>(),
                         result.at("rpm").get<double>(), result.at("rop_m_per_h").get<double>(),
                         1e3 * result.at("depth_of_cut_m").get<double>());
      add_clamp_note(page, result);
    } catch (const nlohmann::json::exception& error) {
      throw base::InputError(fmt::format("{}: not a result of bitrock signal ({})", json.string(), error.what()));
    }
  }
  const double closer = std::max(0.0, time.back() - closer_look_s);
  const auto first = std::lower_bound(time.begin(), time.end(), closer) - time.begin();
  const auto tail = [first](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + first, values.end());
  };
  const auto mean = [](const std::vector<double>& values) { return base::summarise(values).mean; };
  page.plot({.title = "Axial force, " + what,
             .x_label = "time [s]",
             .y_label = "force on bit [kN]",
             .series = {{.name = "", .x = time, .y = force, .colour = report::Colour::blue}},
             .caption = fmt::format("Mean {:.3g} kN, largest {:.3g} kN.", mean(force),
                                    *std::max_element(force.begin(), force.end()))});
  page.plot({.title = "Torque, " + what,
             .x_label = "time [s]",
             .y_label = "torque on bit [N m]",
             .series = {{.name = "", .x = time, .y = torque, .colour = report::Colour::vermillion}},
             .caption = fmt::format("Mean {:.4g} N m, largest {:.4g} N m.", mean(torque),
                                    *std::max_element(torque.begin(), torque.end()))});
  page.plots_in_row(
      {{.title = "Axial force, a closer look",
        .x_label = "time [s]",
        .y_label = "force on bit [kN]",
        .series = {{.name = "", .x = tail(time), .y = tail(force), .colour = report::Colour::blue}}},
       {.title = "Torque, a closer look",
        .x_label = "time [s]",
        .y_label = "torque on bit [N m]",
        .series = {{.name = "", .x = tail(time), .y = tail(torque), .colour = report::Colour::vermillion}}}},
      "The last quarter of a second of both.");
}

}  // namespace bitrock::views
