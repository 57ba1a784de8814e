#pragma once
/// The cells of a table whose columns stand apart by commas, by tabs or by blanks, whichever its first row has. Knows
/// nothing of names and numbers.

#include <string>
#include <string_view>
#include <vector>

namespace bitrock::studies {

struct TextRow {
  int line = 0;                    ///< of the file
  std::vector<std::string> cells;  ///< without the blanks and quotes around them
};

/// A file of rows.
struct TableText {
  std::string source;                 ///< file, for messages
  std::string separator;              ///< "comma", "tab" or "blank"
  std::vector<TextRow> rows;          ///< at least one; without empty ones, and without comments
  std::vector<std::string> comments;  ///< lines that begin with #, as they are
};

/// Lines end in LF, CRLF or CR. In a first row apart by blanks, what stands in brackets belongs to the name before it:
/// "MD (ft) INC (deg)" are two. Throws `InputError` for a file without rows, semicolons between columns, open quotes.
TableText split_table(std::string_view text, const std::string& source);

}  // namespace bitrock::studies
