// What a table of numbers may hold, and each message for what it may not.
#include "base/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

std::filesystem::path write(const std::string& text) {
  static const scratch::Folder folder("csv");
  const auto path = folder / "table.csv";
  base::write_whole(path, text);
  return path;
}

/// What is said when the file is read and each of its columns is asked for.
std::string message(const std::string& text) {
  try {
    const base::CsvTable table = base::read_csv(write(text));
    for (const std::string& name : table.names) table.column(name);
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
  EXPECT_EQ(message("a;b\n1;2\n"),
            "table.csv:1: semicolons between the columns: 'a;b' (columns must be separated by commas, and numbers have "
            "a point; out of Excel: "
            "docs/guide/my_data_into_the_networks.md)");
  EXPECT_EQ(message("a\tb\n1\t2\n"),
            "table.csv:1: tabs between the columns: 'a\tb' (columns must be separated by commas, and numbers have a "
            "point; out of Excel: "
            "docs/guide/my_data_into_the_networks.md)");
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
  EXPECT_EQ(message(text),
            "table.csv:2: column hash: '12e4567890123456' is beyond what a number can be here (1e-308 to 1e308)");
}

TEST(Csv, MissingColumnNamesTheNearest) {
  const base::CsvTable table = base::read_csv(write("depth_mm\n1\n"));
  EXPECT_THROW(table.column("dept_mm"), base::InputError);
}

TEST(Csv, QuotesKeepCommasQuotesAndLineBreaksTogether) {
  const base::CsvTable table =
      base::read_csv(write("\"Zeit, s\" ,\"the \"\"true\"\" force, N\",\"of\r\nthe bit\"\n0,\"1.5\",2\n3,4,5\n"));
  EXPECT_EQ(table.names, (std::vector<std::string>{"Zeit, s", "the \"true\" force, N", "of the bit"}));
  EXPECT_EQ(table.column("the \"true\" force, N"), (std::vector<double>{1.5, 4.0}));
  EXPECT_EQ(table.lines, (std::vector<int>{3, 4}));  // the header takes two lines
}

TEST(Csv, QuotesThatAreNoneOfTheFormatAreRefused) {
  EXPECT_EQ(message("a,b\n1,2\n\"3,4\n5,6\n"), "table.csv:3: a quote opens and does not close");
  EXPECT_EQ(
      message("a,b\n1,\"2\"x\n"),
      "table.csv:2: 'x' behind a closing quote (a comma or the end of the line must follow; a quote within quotes "
      "is doubled)");
  EXPECT_NE(message("\"Zeit, s\";\"Kraft, N\"\n").find("';' behind a closing quote"), std::string::npos);
}

TEST(Csv, TextThatNeedsQuotesIsWrittenWithThem) {
  const std::string text = base::csv_text({"a, b", "c"}, {{1.0}, {2.0}}, "why", {"no \"contact\", at all"});
  EXPECT_EQ(text, "\"a, b\",c,why\n1,2,\"no \"\"contact\"\", at all\"\n");
  const base::CsvTable table = base::read_csv(write(text), false, {"why"});
  EXPECT_EQ(table.column("a, b")[0], 1.0);
  EXPECT_EQ(table.texts.at("why")[0], "no \"contact\", at all");
}

TEST(Csv, OnlyColumnsThatAreUsedMustHoldNumbers) {
  const base::CsvTable table =
      base::read_csv(write("rock,force_N,spare,spare,date\ngranite,1,,,2026-11-29\n12,2,7,8,\n"));
  EXPECT_EQ(table.column("force_N"), (std::vector<double>{1.0, 2.0}));
  const auto refusal = [&](const char* name) {
    try {
      table.column(name);
    } catch (const base::InputError& error) {
      const std::string what = error.what();
      return what.substr(what.find("table.csv"));
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal("rock"), "table.csv:2: column rock: 'granite' is not a number");
  EXPECT_EQ(refusal("spare"), "table.csv:1: column 'spare' appears twice");
  EXPECT_EQ(refusal("date"), "table.csv:2: column date: '2026-11-29' is not a number");
}

TEST(Csv, AllMissingColumnsAreNamedAtOnce) {
  const base::CsvTable table = base::read_csv(write("case,x_mean,depth_of_cut\n1,2,3\n"));
  const auto refusal = [&](const std::vector<std::string>& needed) {
    try {
      table.require(needed);
    } catch (const base::InputError& error) {
      const std::string what = error.what();
      return what.substr(what.find("table.csv"));
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal({"case", "x_mean"}), "accepted");
  EXPECT_EQ(refusal({"case", "x_amean", "depth_of_cut_mm", "back_rake_deg"}),
            "table.csv: columns are missing: x_amean (is it x_mean?), depth_of_cut_mm (is it depth_of_cut?), "
            "back_rake_deg; needed are: case, x_amean, depth_of_cut_mm, back_rake_deg; the file has: case, x_mean, "
            "depth_of_cut");
  // a column that is needed under its own name is not meant by another
  EXPECT_EQ(refusal({"cases", "case", "x_mean"}),
            "table.csv: a column is missing: cases; needed are: cases, case, x_mean; the file has: case, x_mean, "
            "depth_of_cut");
  EXPECT_EQ(refusal({"time_s", "force"}),
            "table.csv: columns are missing: time_s, force; the file has: case, x_mean, depth_of_cut");
  EXPECT_EQ(refusal({"x_mea"}), "table.csv: no column x_mea (is it x_mean?); the file has: case, x_mean, depth_of_cut");
}

TEST(Csv, ColumnsWithoutANameAndRowsWithoutACellArePassedOver) {
  const base::CsvTable behind = base::read_csv(write("time_s,F,,\n0,1,,\n1,2\n,,\n2,3,\n"));
  EXPECT_EQ(behind.names, (std::vector<std::string>{"time_s", "F"}));
  EXPECT_EQ(behind.column("F"), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(behind.lines, (std::vector<int>{2, 3, 5}));
  EXPECT_EQ(base::read_csv(write("a,b\n1,2,\n")).column("b")[0], 2.0);
  // what other programs put first: the number of the row
  EXPECT_EQ(base::read_csv(write(",a\nfirst,1\nsecond,2\n")).column("a"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(message("a,b,\n1,2,3\n"), "table.csv:2: 3 values (the header has 2 columns)");
  EXPECT_EQ(message("a,b\n1,\n"), "table.csv:2: column b: an empty text is not a number");
  EXPECT_EQ(message(",,\n1,2,3\n"), "table.csv:1: a header without names");
}

TEST(Csv, LinesMayEndAsAnySystemEndsThem) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string e = end;
    const base::CsvTable table = base::read_csv(write("a,b" + e + "1,2" + e + e + "3,4"));
    EXPECT_EQ(table.column("b"), (std::vector<double>{2.0, 4.0}));
    EXPECT_EQ(table.lines, (std::vector<int>{2, 4}));
  }
}

TEST(Csv, NumbersInOtherFormsAreRefused) {
  EXPECT_EQ(message("a,b\n1,\"0,5\"\n"), "table.csv:2: column b: '0,5' is not a number (decimal comma: write 0.5)");
  EXPECT_EQ(message("a\n0x14\n"), "table.csv:2: column a: '0x14' is not a number (hexadecimal: write decimal digits)");
  EXPECT_EQ(message("a\n1e999\n"),
            "table.csv:2: column a: '1e999' is beyond what a number can be here (1e-308 to 1e308)");
  EXPECT_EQ(message("a,b\n0,5,0\n"), "table.csv:2: 3 values (the header has 2 columns)");  // a comma too many
  EXPECT_EQ(message("Zeit, s;Kraft, N\n0,0;0,5\n"),
            "table.csv:1: semicolons between the columns: 's;Kraft' (columns must be separated by commas, and numbers "
            "have a point; out of Excel: "
            "docs/guide/my_data_into_the_networks.md)");
}

TEST(Csv, AHeaderBehindACommentSignIsNamed) {
  EXPECT_EQ(message("# time_s, force_N\n0,1\n"),
            "table.csv:2: '0' in the header (the first line gives the columns' names; a line that begins with # is a "
            "comment)");
}

TEST(Csv, OtherEncodingsAreRefusedByName) {
  using namespace std::string_literals;
  EXPECT_EQ(message("\xff\xfe"s + "a\0\n\0"s), "table.csv: the text is in UTF-16, little-endian (save it as UTF-8)");
  EXPECT_EQ(message("a,b\n1,2\0\n"s), "table.csv:2: a NUL byte (no text has one: the file is damaged, or is no text)");
  EXPECT_EQ(message("Kraft,Temp \xb0\x43\n1,2\n"),
            "table.csv:1: byte B0 is not UTF-8 (is the text in Latin-1 or Windows-1252? save it as UTF-8)");
}

}  // namespace
