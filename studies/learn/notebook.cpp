#include "studies/learn/notebook.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/json.hpp"

namespace bitrock::studies {

namespace {

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / notebook_name;
}

}  // namespace

LearnNotebook read_notebook(const std::filesystem::path& folder) {
  LearnNotebook notebook;
  const std::filesystem::path file = file_in(folder);
  if (!base::is_there(file)) return notebook;
  const nlohmann::json json = base::json_from_text(base::read_whole(file), file.string());
  try {
    notebook.request = json.at("request").get<std::string>();
    notebook.batches = json.at("batches").get<std::vector<int>>();
    notebook.elapsed = json.at("elapsed_s").get<double>();
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError(
        fmt::format("{}: {} (it is written by bitrock learn; take another folder)", file.string(), error.what()));
  }
  for (const int cuts : notebook.batches) {
    if (cuts < 1 || cuts > 1000000)
      throw base::InputError(fmt::format("{}: a batch of {} cuts (must be from 1 to 1000000)", file.string(), cuts));
  }
  if (!(notebook.elapsed >= 0.0))
    throw base::InputError(fmt::format("{}: elapsed_s = {} (must be at least 0)", file.string(), notebook.elapsed));
  return notebook;
}

void write_notebook(const std::filesystem::path& folder, const LearnNotebook& notebook) {
  const nlohmann::ordered_json json{
      {"request", notebook.request}, {"batches", notebook.batches}, {"elapsed_s", notebook.elapsed}};
  base::write_whole(file_in(folder), json.dump(2) + "\n");
}

}  // namespace bitrock::studies
