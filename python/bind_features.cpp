// Tables of peak statistics: features.csv and its like.
#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/temporary_folder.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/columns.hpp"
#include "python/input.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

/// Columns that count; all others are measured.
bool is_count(const std::string& name) {
  return name == "case" || name == "seed" || name == "seeds";
}

py::dict read_features(const py::object& path) {
  const std::filesystem::path file = input_path(path);
  const base::CsvTable numbers = base::read_csv(file, true);
  std::vector<std::string> words;
  for (std::size_t k = 0; k < numbers.names.size(); ++k) {
    if (!numbers.problems[k].empty()) words.push_back(numbers.names[k]);
  }
  const base::CsvTable table = words.empty() ? numbers : base::read_csv(file, true, words);
  py::dict columns;
  for (const std::string& name : numbers.names) {
    if (const auto text = table.texts.find(name); text != table.texts.end()) {
      columns[name.c_str()] = py::module_::import("numpy").attr("array")(py::cast(text->second));
    } else if (is_count(name)) {
      columns[name.c_str()] = py::array(given(table.column(name))).attr("astype")("int64");
    } else {
      columns[name.c_str()] = given(table.column(name));
    }
  }
  return columns;
}

/// Through a file, so that one reader checks all data.
surrogate::TrainingData read_columns(const py::dict& data) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  for (const auto& [key, value] : data) {
    const std::string name = py::str(key);
    const py::array column = py::module_::import("numpy").attr("asarray")(value);
    if (column.dtype().kind() == 'U' || column.dtype().kind() == 'O') continue;  // text, such as the hash
    const Doubles numbers = series_of(column, name);
    if (!columns.empty() && columns.front().size() != static_cast<std::size_t>(numbers.size())) {
      throw base::InputError(fmt::format("column {} has {} rows, column {} has {} (all must have the same)", name,
                                         numbers.size(), names.front(), columns.front().size()));
    }
    names.push_back(name);
    columns.emplace_back(numbers.data(), numbers.data() + numbers.size());
  }
  if (columns.empty()) throw base::InputError("data: no columns of numbers");
  const base::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "arrays.csv";
  base::write_whole(file, base::csv_text(names, columns));
  return surrogate::read_training_data(file);
}

}  // namespace

surrogate::TrainingData training_data(const py::object& data) {
  if (py::isinstance<py::list>(data) || py::isinstance<py::tuple>(data)) {
    std::vector<surrogate::TrainingData> tables;
    for (const py::handle& table : data) tables.push_back(training_data(py::reinterpret_borrow<py::object>(table)));
    return surrogate::joined(tables);
  }
  return py::isinstance<py::dict>(data) ? read_columns(data) : surrogate::read_training_data(input_path(data));
}

void bind_features(py::module_& module) {
  module.def(
      "read_features", &read_features, py::arg("path"),
      "Read a table with a header (.csv), such as features.csv: a dict of arrays of shape (rows,), one a column\n"
      "(pandas.DataFrame takes it as it is). Units stand in the names. case, seed and seeds are int64, other\n"
      "numbers float64; columns that hold something else are arrays of str.");
}

}  // namespace bitrock::python
