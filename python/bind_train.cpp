// Networks from a table of peak statistics.
#include "surrogate/train/train.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "python/bindings.hpp"
#include "python/columns.hpp"
#include "python/computing.hpp"
#include "surrogate/train/data_warnings.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using surrogate::TrainOptions;

surrogate::OutputActivation activation_named(const std::string& name) {
  const auto activation = surrogate::output_activation(name);
  if (!activation)
    throw base::InputError(fmt::format("output_activation '{}' (must be rectified, softplus or linear)", name));
  return *activation;
}

surrogate::Model train(const py::object& data_source, TrainOptions options, const py::object& progress) {
  const surrogate::TrainingData data = training_data(data_source);
  if (options.init_from == nullptr)
    surrogate::require_varied_inputs(data.rows, surrogate::learnt_further(data), data.file);
  warn(surrogate::warnings(data));
  surrogate::check_options(options);
  warn(surrogate::learning_warnings(data, options));
  return computed(progress, {"training", "epochs"},
                  [&](const base::ProgressCallback& listener) { return surrogate::train(data, options, listener); });
}

}  // namespace

void bind_train(py::module_& module) {
  const TrainOptions usual = surrogate::recommended();
  module.def(
      "train",
      [](const py::object& data, int epochs, int batch, double learning_rate, std::uint64_t seed, double split,
         const surrogate::Model* init_from, const std::vector<int>& layers, const std::string& output_activation,
         bool log_targets, int smoothing, double validation, std::optional<int> patience, int starts, bool single_cuts,
         bool weighted, bool from_cases, bool shuffle, const std::string& rock, std::optional<int> threads,
         const py::object& progress) {
        TrainOptions options = surrogate::recommended();
        options.epochs = epochs;
        options.batch = batch;
        options.learning_rate = learning_rate;
        options.seed = seed;
        options.split = split;
        options.init_from = init_from;
        options.layers = layers;
        options.output = activation_named(output_activation);
        options.log_targets = log_targets;
        options.smoothing = smoothing;
        options.validation = validation;
        options.patience = patience.value_or(validation > 0.0 ? surrogate::recommended_patience : 0);
        options.starts = starts;
        options.averaged = !single_cuts;
        options.weighted = weighted;
        options.taught = !from_cases;
        options.shuffle = shuffle;
        options.rock = rock;
        options.threads = threads.value_or(base::available_cores());
        return train(data, options, progress);
      },
      py::arg("data"), py::kw_only(), py::arg("epochs") = usual.epochs, py::arg("batch") = usual.batch,
      py::arg("learning_rate") = usual.learning_rate, py::arg("seed") = usual.seed, py::arg("split") = usual.split,
      py::arg("init_from") = py::none(), py::arg("layers") = usual.layers,
      py::arg("output_activation") = std::string(surrogate::name_of(usual.output)),
      py::arg("log_targets") = usual.log_targets, py::arg("smoothing") = usual.smoothing,
      py::arg("validation") = usual.validation, py::arg("patience") = py::none(), py::arg("starts") = usual.starts,
      py::arg("single_cuts") = !usual.averaged, py::arg("weighted") = usual.weighted,
      py::arg("from_cases") = !usual.taught, py::arg("shuffle") = usual.shuffle, py::arg("rock") = usual.rock,
      py::arg("threads") = py::none(), py::arg("progress") = py::none(),
      "Fit ten small networks to peak statistics (Model). The defaults are those of `bitrock train`.\n\n"
      "data: a table (features.csv), or a dict of its columns: case, cutter_speed_m_per_s, depth_of_cut_mm,\n"
      "back_rake_deg, cut_length_m, and for x and y {amax_N_per_m, amean_N_per_m, np1, np23, np4}; seed where there "
      "are\n"
      "several cuts of a case. Counts are of the whole cut. A list of tables is learnt from together.\n"
      "split: share of the cases to learn from. smoothing: epochs over which the parameters that are kept are "
      "averaged.\n"
      "validation: share of the cases to learn from that only say which epoch is best. starts: random starts, of "
      "which\n"
      "the best is kept. init_from: a Model to begin with. threads: None for all cores; the bits do not depend on it.\n"
      "from_cases: learn from the cases themselves, not from a smooth formula through them; so it is with init_from.\n"
      "progress: True for a line on sys.stderr, or a function of (done, total), in epochs.");
}

}  // namespace bitrock::python
