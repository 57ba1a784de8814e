#include "views/vtk/vtk_writer.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/files.hpp"
#include "base/numbered_files.hpp"

namespace bitrock::views {

namespace {

constexpr int digits = 4;

}  // namespace

VtkSeriesWriter::VtkSeriesWriter(std::string name, std::filesystem::path folder)
    : name_(std::move(name)), folder_(std::move(folder)) {
  std::error_code ignored;
  std::filesystem::remove(folder_ / (name_ + ".pvd"), ignored);
  base::remove_numbered_files(folder_ / "frames", {.begin = name_ + "_", .end = ".vtp", .digits = digits});
}

void VtkSeriesWriter::add(double time, const VtkPolyData& data, base::Unfinished& written) {
  const std::string file = fmt::format("frames/{}_{:0{}d}.vtp", name_, instants_.size(), digits);
  written.add(folder_ / file);
  base::write_whole(folder_ / file, vtp_text(data));
  instants_.push_back({time, file});
  cells_.push_back(data.offsets.size());
}

VtkSeries VtkSeriesWriter::finish() const {
  VtkSeries series{.name = name_, .list = folder_ / (name_ + ".pvd"), .cells = cells_};
  base::write_whole(series.list, pvd_text(instants_));
  return series;
}

}  // namespace bitrock::views
