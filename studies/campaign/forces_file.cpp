#include "studies/campaign/forces_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "studies/campaign/folder.hpp"

namespace bitrock::studies {

namespace {

constexpr const char* format_name = "bitrock-forces";
constexpr long long format_version = 1;
constexpr std::size_t hash_length = 16;

struct Number {
  const char* path;
  double FeatureRow::*value;
  const char* units;
  const char* meaning;
  base::Range range;
  bool may_lack = false;  ///< in older files; then it is 0
};

struct Whole {
  const char* path;
  int FeatureRow::*value;
  const char* meaning;
};

std::vector<Number> numbers() {
  using base::any, base::at_least, base::positive;
  return {{"/cuts/cutter_speed_m_per_s", &FeatureRow::cutter_speed, "m/s", "cutting speed", positive()},
          {"/cuts/depth_of_cut_m", &FeatureRow::depth_of_cut, "m", "depth of cut", positive()},
          {"/cuts/back_rake_rad", &FeatureRow::back_rake, "rad", "back rake", base::between(0.0, 1.58)},
          {"/cuts/cut_length_m", &FeatureRow::cut_length, "m", "travel of the samples, after the run-in", positive()},
          {"/cuts/duration_s", &FeatureRow::duration, "s", "time of the samples", positive()},
          {"/cuts/energy_residual_fraction", &FeatureRow::energy_residual_fraction, "1",
           "energy not found over the work of the cutter", any()},
          {"/cuts/energy_injected_fraction", &FeatureRow::energy_injected_fraction, "1",
           "energy given by the scheme over the work of the cutter", any()},
          {"/cuts/step_s", &FeatureRow::step, "s", "time step", positive()},
          {"/cuts/core_s", &FeatureRow::core_time, "s", "time on one core", at_least(0.0)},
          {"/cuts/fluid_pressure_Pa", &FeatureRow::mud_pressure, "Pa", "of the mud; 0 without", at_least(0.0), true}};
}

constexpr Whole wholes[]{{"/cuts/case", &FeatureRow::case_number, "number of the case in its study"},
                         {"/cuts/seed", &FeatureRow::seed, "of the rock"},
                         {"/cuts/cracks_tensile", &FeatureRow::cracks_tensile, "elements broken in tension"},
                         {"/cuts/cracks_shear", &FeatureRow::cracks_shear, "elements broken in shear"},
                         {"/cuts/discs", &FeatureRow::discs, "of the bed"}};

constexpr const char* samples_path = "/cuts/samples";
constexpr const char* x_path = "/force/x_N_per_m";
constexpr const char* y_path = "/force/y_N_per_m";

std::vector<float> to_floats(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

std::vector<double> to_doubles(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

[[noreturn]] void refuse(const base::Hdf5Reader& file, const std::string& why) {
  throw base::InputError(fmt::format("{}: {}", file.name(), why));
}

std::vector<std::string> read_hashes(const base::Hdf5Reader& file, std::size_t cuts) {
  const std::string text = file.text_attribute("hashes");
  std::vector<std::string> hashes;
  for (std::size_t begin = 0; begin + hash_length <= text.size(); begin += hash_length)
    hashes.push_back(text.substr(begin, hash_length));
  if (hashes.size() != cuts || text.size() != cuts * hash_length)
    refuse(file, fmt::format("hashes of {} letters for {} cuts (must be {} a cut)", text.size(), cuts, hash_length));
  std::set<std::string> seen;
  for (const std::string& hash : hashes) {
    if (!is_hash(hash)) refuse(file, fmt::format("hash '{}' (must be {} hexadecimal digits)", hash, hash_length));
    if (!seen.insert(hash).second) refuse(file, fmt::format("the cut with the hash {} is there twice", hash));
  }
  return hashes;
}

/// The part of all forces that belongs to one cut.
std::vector<float> part(const base::Hdf5Reader& file, const char* path, const std::vector<double>& all,
                        std::size_t begin, std::size_t count) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = first + static_cast<std::ptrdiff_t>(count);
  if (!std::all_of(first, last, [](double value) { return std::isfinite(value); }))
    refuse(file, fmt::format("{} holds a force that is not a finite number", path));
  return {first, last};
}

}  // namespace

CutForces forces_of(const Job& job, const dem2d::CutRun& run) {
  return {.cut = row_of(job, run), .x = to_floats(run.force_x), .y = to_floats(run.force_y)};
}

FeatureRow row_of(const CutForces& forces, const peaks::PeakDefinition& definition) {
  FeatureRow row = forces.cut;
  fill_statistics(row, to_doubles(forces.x), to_doubles(forces.y), definition);
  return row;
}

void write_forces(const ForcesFile& forces, const std::filesystem::path& path) {
  base::Hdf5Writer file;
  file.head(format_name, format_version);
  file.attribute("study", forces.study);
  file.attribute("mean_grain_diameter_m", forces.mean_diameter);
  std::string hashes;
  std::vector<int> samples;
  std::vector<float> x, y;
  for (const CutForces& cut : forces.cuts) {
    hashes += cut.cut.hash;
    samples.push_back(static_cast<int>(cut.x.size()));
    x.insert(x.end(), cut.x.begin(), cut.x.end());
    y.insert(y.end(), cut.y.begin(), cut.y.end());
  }
  file.attribute("hashes", hashes);
  for (const Number& number : numbers()) {
    std::vector<double> values;
    for (const CutForces& cut : forces.cuts) values.push_back(cut.cut.*number.value);
    file.array(number.path, values, number.units, number.meaning);
  }
  for (const Whole& whole : wholes) {
    std::vector<int> values;
    for (const CutForces& cut : forces.cuts) values.push_back(cut.cut.*whole.value);
    file.array(whole.path, values, "1", whole.meaning);
  }
  file.array(samples_path, samples, "1", "samples of each cut, one cut after the other");
  file.array(x_path, x, "N/m", "resistance to cutting, mean over the sampling distance");
  file.array(y_path, y, "N/m", "push out of the rock, mean over the sampling distance");
  file.save(path);
}

bool is_forces_file(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  return file.has_attribute("format") && file.text_attribute("format") == format_name;
}

ForcesFile read_forces(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  file.require_format(format_name, format_version);
  ForcesFile forces{.study = file.text_attribute("study"),
                    .mean_diameter = file.number_attribute("mean_grain_diameter_m")};
  if (!(forces.mean_diameter > 0.0))
    refuse(file, fmt::format("mean_grain_diameter_m = {} (must be above 0)", forces.mean_diameter));
  const std::vector<int> samples = file.ints(samples_path);
  const std::vector<std::string> hashes = read_hashes(file, samples.size());
  forces.cuts.resize(samples.size());
  for (std::size_t i = 0; i < hashes.size(); ++i) forces.cuts[i].cut.hash = hashes[i];
  const auto fill = [&](const char* path_of, const auto& values, const base::Range& range, auto value) {
    if (values.size() != samples.size())
      refuse(file, fmt::format("{} has {} values for {} cuts", path_of, values.size(), samples.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!range.contains(static_cast<double>(values[i])))
        refuse(file, fmt::format("{} of cut {} = {} (must be {})", path_of, i, values[i], range.text()));
      forces.cuts[i].cut.*value = values[i];
    }
  };
  for (const Number& number : numbers()) {
    if (number.may_lack && !file.has(number.path)) continue;
    fill(number.path, file.doubles(number.path), number.range, number.value);
  }
  const base::Range not_negative = base::between(0.0, 2147483647.0);
  for (const Whole& whole : wholes) fill(whole.path, file.ints(whole.path), not_negative, whole.value);

  const std::vector<double> x = file.doubles(x_path), y = file.doubles(y_path);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i] < 1)
      refuse(file, fmt::format("{} of cut {} = {} (must be at least 1)", samples_path, i, samples[i]));
    const auto count = static_cast<std::size_t>(samples[i]);
    if (x.size() != y.size() || count > x.size() - begin)
      refuse(file, fmt::format("{} and {} values in {} and {} (must be the sum of {})", x.size(), y.size(), x_path,
                               y_path, samples_path));
    forces.cuts[i].x = part(file, x_path, x, begin, count);
    forces.cuts[i].y = part(file, y_path, y, begin, count);
    begin += count;
  }
  if (begin != x.size())
    refuse(file, fmt::format("{} values in {}, but {} says {}", x.size(), x_path, samples_path, begin));
  return forces;
}

}  // namespace bitrock::studies
