#pragma once
/// Files for ParaView, written by hand (its library would be by far our largest dependency): points with vertices,
/// lines or polygons as VTP, the XML format for poly data, and the list of such files over time as PVD. Numbers stand
/// as base64 in one block at the end of the file, little-endian, each array behind its length in bytes as a 64-bit
/// integer, encoded together [VtkXmlFormats].

#include <span>
#include <string>
#include <vector>

namespace bitrock::views {

/// Values at points or cells. Names carry units; they hold letters, digits and underscores only.
struct VtkArray {
  std::string name;
  int components;  ///< 1, or 3 of a vector
  std::vector<double> values;
};
struct VtkIntegers {
  std::string name;
  std::vector<int> values;
};

/// What the cells of a file are.
enum class VtkCells { vertices, lines, polygons };

struct VtkPolyData {
  std::vector<double> x, y, z;  ///< of the points [m]; z empty: 0
  VtkCells cells = VtkCells::vertices;
  std::vector<int> connectivity;  ///< points of all cells, one cell after the other
  std::vector<int> offsets;       ///< for each cell, entries of `connectivity` up to its end
  std::vector<VtkArray> point_arrays, cell_arrays;
  std::vector<VtkIntegers> point_integers, cell_integers;
};

/// The text of a .vtp file.
std::string vtp_text(const VtkPolyData& data);

struct VtkInstant {
  double time;       ///< [s]
  std::string file;  ///< relative to the .pvd file
};

/// The text of a .pvd file.
std::string pvd_text(std::span<const VtkInstant> instants);

}  // namespace bitrock::views
