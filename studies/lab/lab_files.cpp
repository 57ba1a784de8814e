#include "studies/lab/lab_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/numbered_files.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

/// Of the names of all cores under this pressure [Pa].
std::string begin_of(dem2d::LabTest test, double pressure) {
  if (test != dem2d::LabTest::triaxial) return fmt::format("{}_seed_", dem2d::name_of(test));
  return fmt::format("{}_{}MPa_seed_", dem2d::name_of(test), base::in_units(pressure, base::MPa));
}

}  // namespace

std::filesystem::path file_of(const std::filesystem::path& folder, dem2d::LabTest test, const LabCore& core,
                              const char* ending) {
  return folder / fmt::format("{}{}.{}", begin_of(test, core.pressure), core.seed, ending);
}

std::filesystem::path file_of_all(const std::filesystem::path& folder, dem2d::LabTest test) {
  return folder / fmt::format("{}_curves.png", dem2d::name_of(test));
}

std::filesystem::path rock_file_of(const std::filesystem::path& folder, dem2d::LabTest test) {
  return folder / fmt::format("{}_rock.toml", dem2d::name_of(test));
}

std::vector<std::filesystem::path> files_of(const LabSeries& series, const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  std::vector<std::filesystem::path> files{file_of_all(folder, series.test), rock_file_of(folder, series.test)};
  for (const LabCore& core : cores_of(series)) {
    for (const char* ending : {"csv", "png"}) files.push_back(file_of(folder, series.test, core, ending));
  }
  return files;
}

std::vector<std::string> other_curves(const LabSeries& series, const std::filesystem::path& folder) {
  std::vector<std::string> others;
  for (const double pressure : series.pressures) {
    for (const base::NumberedFile& file :
         base::numbered_files(folder, {.begin = begin_of(series.test, pressure), .end = ".csv"})) {
      if (std::find(series.seeds.begin(), series.seeds.end(), static_cast<std::uint64_t>(file.number)) ==
          series.seeds.end())
        others.push_back(file.path.filename().string());
    }
  }
  return others;
}

}  // namespace bitrock::studies
