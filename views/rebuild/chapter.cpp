#include "views/rebuild/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/units.hpp"
#include "studies/rebuild/constant_model.hpp"
#include "views/rebuild/figures.hpp"
#include "views/text/rebuild_table.hpp"

namespace bitrock::views {

namespace {

/// So many depths of cut, and not less than this, of a history are shown.
constexpr double shown_depths = 12.0, shown_least = 12e-3;  // [1], [m]

/// The shallowest and the deepest cut, of middle speed and rake among those.
std::vector<std::size_t> shown_cases(const studies::Rebuilding& all) {
  std::vector<std::size_t> by_depth(all.known.size());
  for (std::size_t i = 0; i < by_depth.size(); ++i) by_depth[i] = i;
  const auto depth = [&](std::size_t i) { return all.known[i].conditions().depth_of_cut; };
  std::stable_sort(by_depth.begin(), by_depth.end(), [&](std::size_t a, std::size_t b) { return depth(a) < depth(b); });
  std::vector<std::size_t> shown;
  for (const std::size_t end : {by_depth.front(), by_depth.back()}) {
    std::vector<std::size_t> alike;
    for (const std::size_t i : by_depth) {
      if (depth(i) == depth(end)) alike.push_back(i);
    }
    const std::size_t middle = alike[alike.size() / 2];
    if (shown.empty() || shown.front() != middle) shown.push_back(middle);
  }
  return shown;
}

report::Table measures_table(const studies::Rebuilding& rebuilding, bool from_model, runtime::SignalMode mode) {
  report::Table table{.caption = fmt::format("Rebuilt from the {}: deviations from the DEM, over {} cases.",
                                             way_in_words(from_model, mode), rebuilding.known.size()),
                      .header = {"number", "of", "unit", "rms", "worst", "asked", "within it [%]", "share asked [%]"},
                      .rows = {}};
  for (const studies::Measure& one : studies::measures(rebuilding, from_model, mode)) {
    const int digits = one.unit == "1" ? 3 : 1;
    table.rows.push_back({one.name, one.component == 'b' ? "both" : fmt::format("F_{}", one.component), one.unit,
                          fmt::format("{:.{}f}", one.rms, digits), fmt::format("{:+.{}f}", one.worst, digits),
                          fmt::format("{:g}", one.bar), fmt::format("{:.1f}", 100.0 * one.within),
                          fmt::format("{:g}", 100.0 * one.asked)});
  }
  return table;
}

/// Pauses and quarters, which the article leaves for the future [BitRock2026, sec. 5]: means over the cases of a depth.
report::Table pauses_table(const studies::Rebuilding& all, bool from_model, runtime::SignalMode mode) {
  report::Table table{
      .caption =
          "Stretches without force (at most 1 % of the highest) of the cutting force, and how unevenly its peaks "
          "lie over the quarters of a cut: variance over mean of their numbers, 1 where they come at random. DEM, "
          "and rebuilt from the " +
          way_in_words(from_model, mode) + "; means over the cases of a depth.",
      .header = {"depth of cut [mm]", "cases", "without force, DEM [%]", "rebuilt [%]", "mean stretch, DEM [mm]",
                 "rebuilt [mm]", "quarters, DEM", "rebuilt"},
      .rows = {}};
  struct Portraits {
    std::vector<studies::Portrait> dem, rebuilt;
  };
  std::map<double, Portraits> by_depth;
  for (const studies::RebuiltCut& one : all.comparisons) {
    if (one.from_model != from_model || one.mode != mode) continue;
    Portraits& alike = by_depth[all.known[one.known].conditions().depth_of_cut];
    alike.dem.push_back(all.dem[one.known]);
    alike.rebuilt.push_back(one.rebuilt);
  }
  for (const auto& [depth, alike] : by_depth) {
    const studies::ComponentPortrait dem = mean_of(alike.dem).x, rebuilt = mean_of(alike.rebuilt).x;
    table.rows.push_back(
        {fmt::format("{:.6g}", depth / base::mm), fmt::format("{}", alike.dem.size()),
         fmt::format("{:.0f}", 100.0 * dem.zero_share), fmt::format("{:.0f}", 100.0 * rebuilt.zero_share),
         fmt::format("{:.2f}", dem.zero_period / base::mm), fmt::format("{:.2f}", rebuilt.zero_period / base::mm),
         fmt::format("{:.2f}", dem.quarter_dispersion), fmt::format("{:.2f}", rebuilt.quarter_dispersion)});
  }
  return table;
}

void add_case(report::Page& page, const studies::Rebuilding& all, const studies::RebuiltCut& one,
              const surrogate::Model* model, const studies::RebuildOptions& options) {
  const studies::KnownCase& known = all.known[one.known];
  const std::string way = way_in_words(one.from_model, one.mode);
  const surrogate::Model from =
      one.from_model ? *model : studies::constant_model(studies::own_statistics(all.dem[one.known], known));
  runtime::DrawTally draws;
  const studies::RebuiltForce force = studies::rebuilt_force(from, one.mode, known, 1, options.seed, draws);
  const double length = known.conditions().cut_length;
  const double shown = std::min(length, std::max(shown_least, shown_depths * known.conditions().depth_of_cut));
  for (const report::Plot& plot : history_plots(known, force, way, 0.5 * (length - shown), shown)) page.plot(plot);
  page.plots_in_row(
      spectrum_plots(all.dem[one.known], one.rebuilt),
      fmt::format("{}; {}. Variance in octaves of waves per millimetre; the lowest holds a few lines of a "
                  "cut, so it scatters.",
                  conditions_in_words(known), way));
  page.plots_in_row(exceedance_plots(all.dem[one.known], one.rebuilt), "How often the force is above a level.");
}

}  // namespace

void add_rebuild(report::Page& page, const studies::Rebuilding& rebuilding, const surrogate::Model* model,
                 const studies::RebuildOptions& options) {
  page.paragraph(
      "A drill string does not get the force of the DEM but one that the runtime rebuilds from a few numbers of it. "
      "Both should have the same mean, spread, lengths and damage; single peaks lie elsewhere, as they do in another "
      "piece of the same rock.");
  for (const bool from_model : {false, true}) {
    for (const runtime::SignalMode mode : options.modes) {
      const report::Table table = measures_table(rebuilding, from_model, mode);
      if (table.rows.empty()) continue;
      page.table(table);
      page.plots_in_row(parity_plots(rebuilding, from_model, mode),
                        "Rebuilt against DEM, a mark a case; from the " + way_in_words(from_model, mode) + ".");
      page.table(pauses_table(rebuilding, from_model, mode));
    }
  }
  for (const std::size_t i : shown_cases(rebuilding)) {
    for (const studies::RebuiltCut& one : rebuilding.comparisons) {
      if (one.known == i) add_case(page, rebuilding, one, model, options);
    }
  }
}

}  // namespace bitrock::views
