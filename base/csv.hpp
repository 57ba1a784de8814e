#pragma once
/// Tables of numbers in comma-separated text: a header line with names, then one row a line.
/// Lines that begin with '#' and empty lines are skipped. Columns that the reader names may hold text instead.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace base {

struct CsvTable {
  std::string source;                                     ///< file name, for messages
  std::vector<std::string> names;                         ///< of the columns of numbers
  std::vector<std::vector<double>> columns;               ///< one vector a column, all of one length
  std::map<std::string, std::vector<std::string>> texts;  ///< columns of text, by name
  std::vector<int> lines;                                 ///< source line of each row

  std::size_t rows() const { return lines.size(); }
  bool has(const std::string& name) const;
  /// The column of that name; throws `InputError` naming the nearest existing one.
  const std::vector<double>& column(const std::string& name) const;
};

/// Throws `InputError` with file, line and column for text in a number's place, rows of another length, an empty file
/// or a header without rows. NaN and infinities are errors too unless `allow_not_finite`. Columns named in
/// `text_columns` are taken as text, where the file has them.
CsvTable read_csv(const std::filesystem::path& path, bool allow_not_finite = false,
                  const std::vector<std::string>& text_columns = {});

/// Numbers with the digits needed to read them back bit for bit.
std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns);
/// The same with one more column, of text, at the end.
std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns,
                     const std::string& text_name, const std::vector<std::string>& texts);

}  // namespace base
