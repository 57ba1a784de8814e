#include "base/numbered_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

/// The number in a name of the series.
std::optional<long long> number_in(const std::string& name, const Series& series) {
  if (name.size() <= series.begin.size() + series.end.size()) return std::nullopt;
  const char *first = name.data() + series.begin.size(), *last = name.data() + name.size() - series.end.size();
  long long number = -1;
  const auto [stop, error] = std::from_chars(first, last, number);
  if (error != std::errc{} || stop != last || number < 0) return std::nullopt;
  const std::string written = fmt::format("{}{:0{}}{}", series.begin, number, series.digits, series.end);
  return written == name ? std::optional(number) : std::nullopt;
}

}  // namespace

std::vector<NumberedFile> numbered_files(const std::filesystem::path& folder, const Series& series) {
  std::vector<NumberedFile> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const auto number = number_in(entry.path().filename().string(), series);
    if (number) files.push_back({.path = entry.path(), .number = *number});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return files;
}

void remove_numbered_files(const std::filesystem::path& folder, const Series& series) {
  for (const NumberedFile& file : numbered_files(folder, series)) {
    std::error_code error;
    std::filesystem::remove(file.path, error);
    if (error) {
      throw OutputError(
          fmt::format("cannot remove {}, which is of an earlier result: {}", file.path.string(), error.message()));
    }
  }
}

}  // namespace bitrock::base
