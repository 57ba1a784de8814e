#include <array>

#include "views/networks/chapter.hpp"

namespace bitrock::views {

namespace {

// Errors below this are drawn at the edge: a network that knows its few cases by heart says nothing there.
constexpr double lowest_drawn_error = 1e-8;

report::Plot learning_plot(const surrogate::Model& model, const std::string& title, std::size_t from, std::size_t to) {
  constexpr std::array colours{report::Colour::blue,   report::Colour::vermillion, report::Colour::green,
                               report::Colour::purple, report::Colour::orange,     report::Colour::sky,
                               report::Colour::black};
  static_assert(colours.size() >= surrogate::moment_count);
  report::Plot plot{.title = title, .x_label = "epoch", .y_label = "mean squared error [scaled, 1]", .log_y = true};
  for (std::size_t k = from; k < to; ++k) {
    const surrogate::OutputModel& output = model.outputs[k];
    report::Series train{.name = output.variable.name, .colour = colours[k - from]},
        test{.name = "", .style = report::Style::dashed, .colour = colours[k - from]};
    for (const surrogate::LearningPoint& point : output.learning_curve) {
      train.x.push_back(point.epoch);
      train.y.push_back(point.train_mse);
      test.x.push_back(point.epoch);
      test.y.push_back(point.test_mse);
    }
    plot.series.push_back(std::move(train));
    plot.series.push_back(std::move(test));
  }
  plot.y_range = report::AxisRange{lowest_drawn_error, 10.0};
  return plot;
}

}  // namespace

void add_learning_curves(report::Page& page, const surrogate::Model& model) {
  page.plots_in_row(
      {learning_plot(model, "Cutting force x", 0, surrogate::statistics_count),
       learning_plot(model, "Axial force y", surrogate::statistics_count, surrogate::article_output_count)},
      "Mean squared error over the epochs. Solid: cases learnt from. Dashed: test cases.");
  if (surrogate::has_moments(model))
    page.plots_in_row(
        {learning_plot(model, "What rebuilds the force", surrogate::article_output_count, surrogate::most_outputs)},
        "The same of the networks of mean, standard deviation, correlation lengths and correlation.");
}

}  // namespace bitrock::views
