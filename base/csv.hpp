#pragma once
/// Tables of numbers in comma-separated text [RFC4180]: a header line with names, then one row a line. A name or a cell
/// with a comma in it stands in quotes, a quote in it is doubled, and a line break in it counts as a space. Lines end
/// in LF, CRLF or CR. Lines that begin with '#', empty lines and rows of empty cells are skipped, and so are columns
/// without a name. Numbers are those of base/number.hpp, text is UTF-8 (base/encoding.hpp).
///
/// Only columns that somebody asks for must hold numbers and must have a name of their own: other columns may hold what
/// they like. Columns that the reader names may hold text.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bitrock::base {

struct CsvTable {
  std::string source;                                     ///< file name, for messages
  std::vector<std::string> names;                         ///< of the columns, without those read as text
  std::vector<std::vector<double>> columns;               ///< one vector a column; empty where there is a problem
  std::vector<std::string> problems;                      ///< why a column cannot be used, a message; empty if it can
  std::map<std::string, std::vector<std::string>> texts;  ///< columns of text, by name
  std::vector<int> lines;                                 ///< source line of each row

  /// Number of rows below the header.
  std::size_t rows() const { return lines.size(); }
  /// Whether there is a column of that name.
  bool has(const std::string& name) const;
  /// Throws `InputError` that names all of these that are missing, each with the nearest column that is not needed
  /// under its own name, and the columns that there are.
  void require(const std::vector<std::string>& needed) const;
  /// The column of that name, which is required; throws `InputError` with the place of the first cell that is no
  /// number, or that the name stands twice.
  const std::vector<double>& column(const std::string& name) const;
};

/// Throws `InputError` with file and line for another encoding or separator, quotes that do not close, rows of another
/// length, an empty file or a header without rows. Cells `nan` and `inf` are numbers only with `allow_not_finite`.
/// Columns named in `text_columns` are taken as text, where the file has them.
CsvTable read_csv(const std::filesystem::path& path, bool allow_not_finite = false,
                  const std::vector<std::string>& text_columns = {});

/// Names of columns in a message: with commas between them, and in quotes where they have commas of their own.
std::string listed(const std::vector<std::string>& names);

/// Numbers with the digits needed to read them back bit for bit; names in quotes where they need them.
std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns);
/// The same with one more column, of text, at the end.
std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns,
                     const std::string& text_name, const std::vector<std::string>& texts);

}  // namespace bitrock::base
