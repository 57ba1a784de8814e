#include "studies/lab/lab_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/numbered_files.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

/// Of the names of all cores under the pressure, or with the cut, of this one.
std::string begin_of(dem2d::LabTest test, const LabCore& core) {
  if (test == dem2d::LabTest::triaxial)
    return fmt::format("triaxial_{}MPa_seed_", base::in_units(core.pressure, base::MPa));
  if (test == dem2d::LabTest::toughness)
    return fmt::format("toughness_{}mm_seed_", base::in_units(core.notch, base::mm));
  return fmt::format("{}_seed_", dem2d::name_of(test));
}

}  // namespace

std::filesystem::path file_of(const std::filesystem::path& folder, dem2d::LabTest test, const LabCore& core,
                              const char* ending) {
  return folder / fmt::format("{}{}.{}", begin_of(test, core), core.seed, ending);
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
  std::set<std::string> begins, others;
  for (const LabCore& core : cores_of(series)) begins.insert(begin_of(series.test, core));
  for (const std::string& begin : begins) {
    for (const base::NumberedFile& file : base::numbered_files(folder, {.begin = begin, .end = ".csv"})) {
      if (std::find(series.seeds.begin(), series.seeds.end(), static_cast<std::uint64_t>(file.number)) ==
          series.seeds.end())
        others.insert(file.path.filename().string());
    }
  }
  return {others.begin(), others.end()};
}

}  // namespace bitrock::studies
