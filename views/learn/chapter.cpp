#include "views/learn/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "surrogate/net/model.hpp"
#include "views/text/learn_lines.hpp"

namespace bitrock::views {

namespace {

/// What was known after the first so many cuts.
studies::Knowledge known_after(const surrogate::TrainingData& data, std::size_t cuts) {
  surrogate::TrainingData first = data;
  first.rows.resize(cuts);
  return studies::knowledge_of(first);
}

report::Table table_of(const studies::Knowledge& knowledge) {
  report::Table table{.caption =
                          "Standard error of a smooth force through all cuts, and how much a single cut scatters "
                          "around it. Of counts: for the mean number in a cut.",
                      .header = {"output", "known to", "a single cut scatters by"},
                      .rows = {}};
  for (std::size_t o = 0; o < knowledge.errors.size(); ++o)
    table.rows.push_back({std::string(surrogate::output_names[o].name), known_to(o, knowledge.errors[o]),
                          known_to(o, knowledge.scatter[o])});
  return table;
}

/// After each batch, and with an hour more at the pace so far.
report::Plot plot_of(const surrogate::TrainingData& data, const studies::LearnNotebook& notebook,
                     const studies::Knowledge& now, double more) {
  report::Series seen{.name = "so far", .style = report::Style::line_and_markers, .colour = report::Colour::blue},
      expected{.name = "an hour more", .style = report::Style::dashed, .colour = report::Colour::blue};
  std::size_t cuts = 0;
  for (const int batch : notebook.batches) {
    if (cuts == data.rows.size()) break;  // the cuts of an unfinished batch are not in the table
    cuts = std::min(cuts + static_cast<std::size_t>(batch), data.rows.size());
    if (cuts < 2) continue;
    seen.x.push_back(static_cast<double>(cuts));
    const bool all = cuts == data.rows.size();
    seen.y.push_back(100.0 * (all ? now : known_after(data, cuts)).force_error);
  }
  constexpr int pieces = 40;
  for (int i = 0; i <= pieces; ++i) {
    const double times = std::pow(more, static_cast<double>(i) / pieces);
    expected.x.push_back(times * now.cuts);
    expected.y.push_back(100.0 * studies::expected_error(now, times));
  }
  report::Plot plot{
      .title = "How well the force is known",
      .x_label = "cuts",
      .y_label = "standard error [%]",
      .caption = "Of the force, after each batch of cuts; as one over the root of their number from there on.",
      .log_x = true,
      .log_y = true};
  plot.series = {seen, expected};
  return plot;
}

}  // namespace

void add_learnt(report::Page& page, const surrogate::TrainingData& data, const studies::LearnNotebook& notebook) {
  if (data.rows.size() < 2) return;
  const studies::Knowledge knowledge = studies::knowledge_of(data);
  const double more = studies::times_cuts_an_hour_later(notebook.elapsed);
  page.section(
      "How well the force is known",
      fmt::format("{} cuts in {}, each under conditions of its own that were chosen to teach most, show a smooth force "
                  "(a formula of {} terms) with a standard error of {:.1f} %: root mean square over highest peak, mean "
                  "peak and mean force of both directions. An hour more would bring it to some {:.1f} %. What a force "
                  "has of kinks, which no such formula follows, comes on top.",
                  knowledge.cuts, base::readable_duration(notebook.elapsed), knowledge.terms,
                  100.0 * knowledge.force_error, 100.0 * studies::expected_error(knowledge, more)));
  page.table(table_of(knowledge));
  page.plot(plot_of(data, notebook, knowledge, more));
}

}  // namespace bitrock::views
