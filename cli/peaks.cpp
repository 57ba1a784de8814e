// bitrock peaks: the five statistics of any force history.
#include "peaks/statistics.hpp"

#include <memory>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "cli/command.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string file, column;
};

struct History {
  std::string column;
  std::vector<double> time;  ///< empty when the file has none
  std::vector<double> force;
};

History from_hdf5(const Options& options) {
  const base::Hdf5Reader file(options.file);
  History history;
  history.column = options.column.empty() ? "x_N_per_m" : options.column;
  const std::string path = history.column.front() == '/' ? history.column : "/force/" + history.column;
  history.force = file.doubles(path);
  if (file.has("/force/time_s")) history.time = file.doubles("/force/time_s");
  return history;
}

History from_csv(const Options& options) {
  const base::CsvTable table = base::read_csv(options.file);
  History history;
  history.column = options.column;
  if (history.column.empty()) {
    std::vector<std::string> forces;
    for (const std::string& name : table.names) {
      if (name != "time_s") forces.push_back(name);
    }
    if (forces.size() != 1) {
      throw base::InputError(
          fmt::format("{}: which column? (choose with --column: {})", options.file, fmt::join(forces, ", ")));
    }
    history.column = forces.front();
  }
  history.force = table.column(history.column);
  if (table.has("time_s")) history.time = table.column("time_s");
  return history;
}

/// The unit a column's name ends in, as far as forces have one; empty otherwise.
std::string unit_of(const std::string& column) {
  for (const auto& [ending, unit] : {std::pair{"_N_per_m", " N/m"}, std::pair{"_N_m", " N m"}, std::pair{"_N", " N"}}) {
    if (column.ends_with(ending)) return unit;
  }
  return "";
}

void run(const Options& options) {
  const bool hdf5 = options.file.ends_with(".h5") || options.file.ends_with(".hdf5");
  const History history = hdf5 ? from_hdf5(options) : from_csv(options);
  if (!history.time.empty() && history.time.size() != history.force.size()) {
    throw base::InputError(fmt::format("{}: {} values in {} but {} times", options.file, history.force.size(),
                                       history.column, history.time.size()));
  }
  require_outputs(options.common, {options.file}, {});
  const peaks::PeakStatistics s = peaks::peak_statistics(history.force);
  nlohmann::json list = nlohmann::json::array();
  for (const std::size_t i : peaks::counted_peaks(history.force)) {
    list.push_back({{"index", i},
                    {"time_s", history.time.empty() ? nlohmann::json() : nlohmann::json(history.time[i])},
                    {"height", history.force[i]}});
  }
  say(options.common, "{} of {}: {} samples, {} peaks\nA_max {:.6g}{}, A_mean {:.6g}{}, NP1 {}, NP23 {}, NP4 {}\n",
      history.column, options.file, history.force.size(), s.count(), s.amax, unit_of(history.column), s.amean,
      unit_of(history.column), s.np1, s.np23, s.np4);
  write_json(options.common, {{"column", history.column},
                              {"amax", s.amax},
                              {"amean", s.amean},
                              {"np1", s.np1},
                              {"np23", s.np23},
                              {"np4", s.np4},
                              {"count", s.count()},
                              {"peaks", list}});
}

}  // namespace

void add_peaks(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("peaks", "peak statistics of a run file or of any CSV force history");
  command->add_option("file", options->file, "run.h5, or a CSV with a header")->required();
  command->add_option("--column", options->column,
                      "which force (default: x_N_per_m, or the only CSV column beside time_s)");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
