#include "views/text/learn_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/progress.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::views {

std::string known_to(std::size_t output, double error) {
  return surrogate::output_names[output].unit == "1" ? fmt::format("{:.2f}", error)
                                                     : fmt::format("{:.1f} %", 100.0 * error);
}

std::string batch_line(const studies::LearnProgress& progress) {
  const double left = std::max(0.0, progress.budget - progress.elapsed);
  return fmt::format("batch {}: {} cuts in {}; the force is known to {:.1f} % (formula of {} terms); {} left\n",
                     progress.batch, progress.knowledge.cuts, base::readable_duration(progress.elapsed),
                     100.0 * progress.knowledge.force_error, progress.knowledge.terms, base::readable_duration(left));
}

std::string learnt_lines(const studies::Learnt& learnt) {
  const studies::LearnProgress& last = learnt.last;
  std::string text =
      fmt::format("{}: {} cuts in {}. Standard error of a smooth force through them:\n",
                  learnt.end == studies::LearnEnd::error_reached ? "known well enough" : "the time is over",
                  last.knowledge.cuts, base::readable_duration(last.elapsed));
  for (std::size_t o = 0; o < last.knowledge.errors.size(); ++o) {
    text += fmt::format("  {:<28} {}\n", surrogate::output_names[o].name, known_to(o, last.knowledge.errors[o]));
  }
  const double more = studies::times_cuts_an_hour_later(last.elapsed);
  return text + fmt::format("An hour more would bring the force from {:.1f} to some {:.1f} %.\n",
                            100.0 * last.knowledge.force_error, 100.0 * studies::expected_error(last.knowledge, more));
}

}  // namespace bitrock::views
