#pragma once
/// Series of files for ParaView in a folder: VTP files of one thing after the other instant, listed over time in a PVD
/// file.

#include <filesystem>
#include <string>
#include <vector>

#include "base/unfinished.hpp"
#include "views/vtk/vtk_file.hpp"

namespace bitrock::views {

/// One of the things shown, over time.
struct VtkSeries {
  std::string name;                ///< "discs", "string"
  std::filesystem::path list;      ///< the PVD file
  std::vector<std::size_t> cells;  ///< at each instant
};

/// Writes NAME.pvd and frames/NAME_0000.vtp, ... into a folder.
class VtkSeriesWriter {
 public:
  /// An earlier export of this name leaves the folder: of a longer run, frames would stay beside ours. The list goes
  /// first, so that there is none of missing frames.
  VtkSeriesWriter(std::string name, std::filesystem::path folder);

  /// The next instant [s]. Its file counts among `written`, which are removed when not all are.
  void add(double time, const VtkPolyData& data, base::Unfinished& written);
  bool empty() const { return instants_.empty(); }  ///< nothing was added
  /// Writes the list.
  VtkSeries finish() const;

 private:
  std::string name_;
  std::filesystem::path folder_;
  std::vector<VtkInstant> instants_;
  std::vector<std::size_t> cells_;
};

}  // namespace bitrock::views
