// What a table of numbers may hold, and each message for what it may not.
#include "base/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

namespace {

std::filesystem::path write(const std::string& text) {
  static const scratch::Folder folder("csv");
  const auto path = folder / "table.csv";
  base::write_whole(path, text);
  return path;
}

std::string message(const std::string& text) {
  try {
    base::read_csv(write(text));
  } catch (const base::InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("table.csv"));
  }
  return "accepted";
}

TEST(Csv, ReadsBackWhatItWrote) {
  const std::vector<std::vector<double>> columns{{1.0, 0.1, 1e-300}, {-2.0, 1.0 / 3.0, 12345678.9}};
  const base::CsvTable table = base::read_csv(write(base::csv_text({"a", "b"}, columns)));
  EXPECT_EQ(table.columns, columns);
  EXPECT_EQ(table.column("b"), columns[1]);
}

TEST(Csv, ToleratesCommentsBlanksQuotesAndWindowsLineEnds) {
  const base::CsvTable table = base::read_csv(write("# made elsewhere\r\n\"a\" , b\r\n\r\n 1 , +2\r\n"));
  EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.columns[1][0], 2.0);
}

TEST(Csv, SkipsAByteOrderMark) {
  EXPECT_TRUE(base::read_csv(write("\xef\xbb\xbftime_s\n1\n")).has("time_s"));
}

TEST(Csv, RefusesWithPlace) {
  EXPECT_EQ(message(""), "table.csv: empty (a header line and rows are needed)");
  EXPECT_EQ(message("a,b\n"), "table.csv: only a header (at least one row is needed)");
  EXPECT_EQ(message("a,b\n1,x\n"), "table.csv:2: column b: 'x' is not a number");
  EXPECT_EQ(message("a,b\n1,nan\n"), "table.csv:2: column b: nan (only finite numbers are allowed)");
  EXPECT_EQ(message("a,b\n1\n"), "table.csv:2: 1 values (the header has 2 columns)");
  EXPECT_EQ(message("a,a\n1,2\n"), "table.csv:1: column 'a' appears twice");
  EXPECT_EQ(message("a;b\n1;2\n"), "table.csv:1: one column, 'a;b' (columns are separated by commas)");
  EXPECT_EQ(message("a\tb\n1\t2\n"), "table.csv:1: one column, 'a\tb' (columns are separated by commas)");
  EXPECT_EQ(message("0,1\n1,2\n"), "table.csv:1: '0' in the header (the first line gives the columns' names)");
  EXPECT_TRUE(std::isnan(base::read_csv(write("a\nnan\n"), true).columns[0][0]));
}

TEST(Csv, ColumnsOfTextAreThoseTheReaderNames) {
  // a hash may look like a number, and even like one that no double holds
  const std::string text = base::csv_text({"a", "b"}, {{1.0, 2.5}, {3.0, 4.0}}, "hash", {"12e4567890123456", "0b"});
  EXPECT_EQ(text, "a,b,hash\n1,3,12e4567890123456\n2.5,4,0b\n");
  const base::CsvTable table = base::read_csv(write(text), false, {"hash", "of no interest"});
  EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.column("b"), (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(table.texts.at("hash"), (std::vector<std::string>{"12e4567890123456", "0b"}));
  EXPECT_FALSE(table.texts.contains("of no interest"));
  const base::CsvTable first = base::read_csv(write("hash,a\nx,7\n"), false, {"hash"});
  EXPECT_EQ(first.column("a")[0], 7.0);
  EXPECT_EQ(message(text), "table.csv:2: column hash: '12e4567890123456' is not a number");
}

TEST(Csv, MissingColumnNamesTheNearest) {
  const base::CsvTable table = base::read_csv(write("depth_mm\n1\n"));
  EXPECT_THROW(table.column("dept_mm"), base::InputError);
}

}  // namespace
