#pragma once
/// The rows of a comma-separated text, cell by cell, as RFC 4180 has them [RFC4180]. Knows quotes and line ends, and
/// neither headers nor numbers: those are `csv.hpp`.

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bitrock::base {

/// One cell: its text, without quotes.
struct CsvCell {
  std::string_view text;  ///< without the blanks around it, and without its quotes
  bool quoted = false;    ///< stood in quotes
};

/// Goes through a text row after row.
class CsvRows {
 public:
  /// `text` and `source`, the name of the file for messages, must outlive the rows.
  CsvRows(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  /// The next row; false at the end. Skips empty lines and comments. The cells are good until the next call. Throws
  /// `InputError` for a quote that does not close and for text behind one that does.
  bool next(std::vector<CsvCell>& cells);

  /// Takes the next row only when it is just so many plain finite numbers with commas between them, as nearly all rows
  /// of long tables are: each byte is then looked at once. False: nothing is taken, `next` knows what it is.
  bool next_numbers(std::span<double> row);

  int line() const { return line_; }                     ///< on which that row begins
  bool skipped_comment() const { return any_comment_; }  ///< since the beginning

 private:
  bool at_end() const { return at_ == text_.size(); }
  bool at_line_end() const { return at_end() || text_[at_] == '\n' || text_[at_] == '\r'; }
  void skip_blanks();
  void skip_line();
  void take_line_end();
  CsvCell take_cell();
  CsvCell take_quoted();

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  int line_ = 0, next_line_ = 1;
  bool any_comment_ = false;
  std::deque<std::string> unquoted_;  ///< of the row: cells with doubled quotes or line breaks, as they are meant
};

/// The text as a cell: in quotes when it needs them.
std::string csv_cell(std::string_view text);

}  // namespace bitrock::base
