#include "studies/learn/learn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "studies/campaign/collect.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/status.hpp"
#include "studies/learn/notebook.hpp"

namespace bitrock::studies {

namespace {

constexpr std::array<std::size_t, 6> forces{0, 1, 5, 6, 10, 12};  // A_max, A_mean, mean, of x and y, among the outputs

/// Spends time on the clock, and writes it down whatever happens.
class Clock {
 public:
  Clock(const std::filesystem::path& folder, LearnNotebook& notebook)
      : folder_(folder), notebook_(notebook), before_(notebook.elapsed) {}
  ~Clock() {
    try {
      write();
    } catch (const std::exception&) {  // the time of this call is lost, no cut is
    }
  }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  double elapsed() const {
    return before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  void write() {
    notebook_.elapsed = elapsed();
    write_notebook(folder_, notebook_);
  }

 private:
  const std::filesystem::path& folder_;
  LearnNotebook& notebook_;
  double before_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::filesystem::path folder_of(const LearnRequest& request, std::size_t batch) {
  return request.folder / "cuts" / fmt::format("batch_{:03}", batch);
}

std::string fingerprint(const LearnRequest& request) {
  return base::fingerprint_text(
      fmt::format("{}\nseed {}\nbatch {}\n", exact_toml(request.like), request.seed, request.batch));
}

/// All cuts of a batch that are done, numbered on from `first_case`.
void add_cuts(const LearnRequest& request, const Study& study, std::size_t batch, int first_case, ForcesFile& all) {
  Collection found = collect(study, folder_of(request, batch), peaks::converging(mean_diameter(study)));
  for (CutForces& cut : found.forces.cuts) {
    cut.cut.case_number += first_case;
    all.cuts.push_back(std::move(cut));
  }
}

void write_tables(const LearnRequest& request, const ForcesFile& all) {
  std::vector<FeatureRow> rows;
  const peaks::PeakDefinition definition = peaks::converging(all.mean_diameter);
  rows.reserve(all.cuts.size());
  for (const CutForces& cut : all.cuts) rows.push_back(row_of(cut, definition));
  write_forces(all, request.folder / "forces.h5");
  base::write_whole(request.folder / "features.csv", features_csv(rows));
  base::write_whole(request.folder / "features_mean.csv", features_mean_csv(rows));
}

/// How many cuts the next batch has: as many as are asked for, fewer at the end of the time, 0 when it is over.
int next_batch(const LearnRequest& request, int cuts_so_far, double elapsed) {
  if (cuts_so_far == 0) return request.batch;
  const double of_a_cut = elapsed / cuts_so_far, left = request.budget - elapsed;
  const int fit = static_cast<int>(std::clamp(std::floor(left / of_a_cut), 0.0, 1e6));
  return fit < 2 * request.workers ? 0 : std::min(fit, request.batch);
}

void run_batch(const LearnRequest& request, const Study& study, std::size_t batch, const LearnListeners& listeners) {
  const std::filesystem::path folder = folder_of(request, batch);
  run(study, folder, {.workers = request.workers, .on_job = listeners.on_job, .on_stage = listeners.on_stage});
  const Status done = status(study, folder);
  if (done.failed > 0)
    throw base::SimulationError(fmt::format("{} cuts failed; the reasons are in {} (the same command tries them again)",
                                            done.failed, (folder / "failed").string()));
}

}  // namespace

Knowledge knowledge_of(const surrogate::TrainingData& data) {
  const std::vector<surrogate::TrainingRow> rows = surrogate::averaged(data).rows;
  const surrogate::SmoothFormula formula = surrogate::fit_formula(rows, surrogate::learnt_further(data));
  const auto n = static_cast<double>(rows.size()), p = static_cast<double>(formula.terms());
  Knowledge knowledge{
      .cuts = static_cast<int>(rows.size()), .terms = static_cast<int>(formula.terms()), .errors = {}, .scatter = {}};
  for (std::size_t o = 0; o < formula.unseen_errors.size(); ++o) {
    double size = 1.0;
    if (surrogate::is_count(o)) {
      double peaks_in_a_cut = 0.0;
      for (const surrogate::TrainingRow& row : rows) peaks_in_a_cut += row.outputs[o] * row.cut_length / n;
      size = peaks_in_a_cut;
    }
    const double scatter = surrogate::scatter_left(formula, o, rows.size());  // s^2
    knowledge.errors.push_back(size > 0.0 ? std::sqrt(scatter * p / n / size) : 0.0);
    knowledge.scatter.push_back(size > 0.0 ? std::sqrt(scatter / size) : 0.0);
  }
  double squares = 0.0;
  int count = 0;
  for (const std::size_t o : forces) {
    if (o >= knowledge.errors.size()) continue;
    squares += knowledge.errors[o] * knowledge.errors[o];
    ++count;
  }
  knowledge.force_error = std::sqrt(squares / count);
  return knowledge;
}

double expected_error(const Knowledge& knowledge, double times_cuts) {
  return knowledge.force_error / std::sqrt(times_cuts);
}

double times_cuts_an_hour_later(double elapsed) {
  constexpr double hour = 3600.0;
  return 1.0 + hour / std::max(elapsed, 1.0);
}

Learnt learn(const LearnRequest& request, const LearnListeners& listeners) {
  LearnNotebook notebook = read_notebook(request.folder);
  const std::string print = fingerprint(request);
  if (!notebook.request.empty() && notebook.request != print) {
    throw base::InputError(fmt::format("{}: begun with another rock, study, seed or batch (take another folder)",
                                       request.folder.string()));
  }
  notebook.request = print;
  base::require_writable_folder(request.folder);
  notebook.elapsed += request.spent;
  Clock clock(request.folder, notebook);
  LearnDesign design(request.like, range_of(request.like), request.seed);
  ForcesFile all{.study = "learn", .mean_diameter = mean_diameter(request.like), .cuts = {}};
  Learnt learnt{.end = LearnEnd::time_over, .last = {.budget = request.budget}};
  int cases = 0;  // of all batches before
  for (std::size_t batch = 1;; ++batch) {
    if (batch > notebook.batches.size()) {
      const int cuts = next_batch(request, static_cast<int>(all.cuts.size()), clock.elapsed());
      if (cuts == 0) break;
      notebook.batches.push_back(cuts);
      clock.write();
    }
    const Study study = design.next(notebook.batches[batch - 1], static_cast<int>(batch));
    run_batch(request, study, batch, listeners);
    add_cuts(request, study, batch, cases, all);
    cases += notebook.batches[batch - 1];
    if (batch < notebook.batches.size()) continue;  // of an earlier call, which went on
    write_tables(request, all);
    clock.write();
    learnt.last = {.batch = static_cast<int>(batch),
                   .knowledge = knowledge_of(surrogate::read_training_data(request.folder / "features.csv")),
                   .elapsed = clock.elapsed(),
                   .budget = request.budget};
    if (listeners.on_batch) listeners.on_batch(learnt.last);
    if (request.error && learnt.last.knowledge.force_error <= *request.error) {
      learnt.end = LearnEnd::error_reached;
      break;
    }
  }
  for (const CutForces& cut : all.cuts) learnt.core_time += cut.cut.core_time;
  return learnt;
}

}  // namespace bitrock::studies
