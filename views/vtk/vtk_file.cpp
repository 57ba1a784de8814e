#include "views/vtk/vtk_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>

#include "base/base64.hpp"

namespace bitrock::views {

namespace {

static_assert(std::endian::native == std::endian::little, "the files say that their numbers are little-endian");

template <class T>
void append_bytes(std::string& bytes, std::span<const T> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

/// The elements of a file that name arrays, and the block at its end that holds them.
class Sections {
 public:
  template <class T>
  void array(const char* type, const std::string& name, int components, std::span<const T> values) {
    const std::uint64_t length = values.size_bytes();
    std::string bytes;
    append_bytes(bytes, std::span<const std::uint64_t>(&length, 1));
    append_bytes(bytes, values);
    fmt::format_to(std::back_inserter(elements_),
                   "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                   "offset=\"{}\"/>\n",
                   type, name, components, block_.size());
    block_ += base::base64(bytes);
  }
  void reals(const std::string& name, int components, const std::vector<double>& values) {
    array<double>("Float64", name, components, values);
  }
  void integers(const std::string& name, const std::vector<int>& values) { array<int>("Int32", name, 1, values); }

  void open(const std::string& element) { elements_ += "      <" + element + ">\n"; }
  void close(const std::string& element) { elements_ += "      </" + element + ">\n"; }
  const std::string& elements() const { return elements_; }
  const std::string& block() const { return block_; }

 private:
  std::string elements_, block_;
};

const char* element_of(VtkCells cells) {
  switch (cells) {
    case VtkCells::vertices:
      return "Verts";
    case VtkCells::lines:
      return "Lines";
    case VtkCells::polygons:
      return "Polys";
  }
  return "";
}

void add_values(Sections& sections, const std::string& element, const std::vector<VtkArray>& reals,
                const std::vector<VtkIntegers>& integers) {
  sections.open(element);
  for (const VtkArray& array : reals) sections.reals(array.name, array.components, array.values);
  for (const VtkIntegers& array : integers) sections.integers(array.name, array.values);
  sections.close(element);
}

}  // namespace

std::string vtp_text(const VtkPolyData& data) {
  std::vector<double> points;
  points.reserve(3 * data.x.size());
  for (std::size_t i = 0; i < data.x.size(); ++i)
    points.insert(points.end(), {data.x[i], data.y[i], data.z.empty() ? 0.0 : data.z[i]});

  Sections sections;
  add_values(sections, "PointData", data.point_arrays, data.point_integers);
  add_values(sections, "CellData", data.cell_arrays, data.cell_integers);
  sections.open("Points");
  sections.reals("position_m", 3, points);
  sections.close("Points");
  const std::string cells = element_of(data.cells);
  sections.open(cells);
  sections.integers("connectivity", data.connectivity);
  sections.integers("offsets", data.offsets);
  sections.close(cells);
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <PolyData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOf{}=\"{}\">\n"
      "{}"
      "    </Piece>\n"
      "  </PolyData>\n"
      "  <AppendedData encoding=\"base64\">_{}</AppendedData>\n"
      "</VTKFile>\n",
      data.x.size(), cells, data.offsets.size(), sections.elements(), sections.block());
}

std::string pvd_text(std::span<const VtkInstant> instants) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const VtkInstant& instant : instants) {
    fmt::format_to(std::back_inserter(text), "    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", instant.time,
                   instant.file);
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace bitrock::views
