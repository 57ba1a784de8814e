// A model as source text and as ONNX: compiled and run beside `predict`. What ONNX' own tools and other programs say of
// the graph is in tests/export.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/random.hpp"
#include "surrogate/export/c_source.hpp"
#include "surrogate/export/columns.hpp"
#include "surrogate/export/matlab_source.hpp"
#include "surrogate/export/onnx_file.hpp"
#include "surrogate/export/source_text.hpp"
#include "tests/export/mixed_model.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using surrogate::CutConditions;
using surrogate::Model;

const std::string strict = " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wmissing-prototypes -Werror -O2 ";
const std::string c99 = std::string(BITROCK_C_COMPILER) + " -std=c99" + strict + "-ffp-contract=off ";
const std::string cpp = std::string(BITROCK_CXX_COMPILER) +
                        " -std=c++11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O2 -ffp-contract=off ";

bool shell(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

std::string quoted(const std::filesystem::path& path) {
  return "'" + path.string() + "' ";
}

/// Within the training range, and as far again on each side; the last three hold not-a-number in one place each.
std::vector<CutConditions> questions(const Model& model, int count) {
  base::Random random(5);
  const auto columns = surrogate::condition_columns(model);
  std::vector<CutConditions> asked;
  for (int i = 0; i < count; ++i) {
    std::array<double, 3> values{};
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double beyond = i % 2 == 0 ? 0.0 : columns[k].high - columns[k].low;
      values[k] = base::uniform(random, columns[k].low - beyond, columns[k].high + beyond);
    }
    asked.push_back({values[0], values[1], values[2]});
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  asked.push_back({none, 0.002, 0.3});
  asked.push_back({1.0, none, 0.3});
  asked.push_back({1.0, 0.002, none});
  return asked;
}

struct Answer {
  std::array<double, surrogate::article_output_count> statistics{};
  bool inside = false;
};

/// What a program built with BITROCK_MAIN answers.
std::vector<Answer> answers(const scratch::Folder& folder, const std::string& program,
                            const std::vector<CutConditions>& asked) {
  std::string lines;
  for (const CutConditions& c : asked) lines += fmt::format("{} {} {}\n", c.cutter_speed, c.depth_of_cut, c.back_rake);
  base::write_whole(folder / "asked", lines);
  EXPECT_TRUE(shell(quoted(folder / program) + "<" + quoted(folder / "asked") + ">" + quoted(folder / "answered")));
  std::istringstream text(base::read_whole(folder / "answered"));
  std::vector<Answer> all;
  std::string line;
  while (std::getline(text, line)) {
    Answer answer;
    const char* at = line.c_str();
    char* end = nullptr;
    for (double& statistic : answer.statistics) {
      statistic = std::strtod(at, &end);  // reads nan, which a stream does not
      at = end;
    }
    answer.inside = std::strtol(at, &end, 10) == 1;
    EXPECT_EQ(*end, '\0') << line;
    all.push_back(answer);
  }
  return all;
}

/// The C file has the operations of `predict` in the same order and the same library: not a bit may differ.
void expect_predicted(const Model& model, const std::vector<CutConditions>& asked, const std::vector<Answer>& given) {
  ASSERT_EQ(given.size(), asked.size());
  int inside = 0;
  std::array<int, surrogate::article_output_count> positive{};
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const surrogate::Prediction expected = surrogate::predict(model, asked[i]);
    const auto statistics = surrogate::listed(expected);
    EXPECT_EQ(given[i].inside, expected.inside_training_range) << i;
    inside += given[i].inside ? 1 : 0;
    for (std::size_t k = 0; k < statistics.size(); ++k) {
      positive[k] += statistics[k] > 0.0 ? 1 : 0;
      if (std::isnan(statistics[k])) {
        EXPECT_TRUE(std::isnan(given[i].statistics[k])) << i << " " << k;
      } else {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(given[i].statistics[k]), std::bit_cast<std::uint64_t>(statistics[k]))
            << i << " " << k << ": " << given[i].statistics[k] << " and " << statistics[k];
      }
    }
  }
  // The comparison says something: both sides of the range, and every network alive, were asked.
  EXPECT_GT(inside, static_cast<int>(asked.size()) / 3);
  EXPECT_LT(inside, static_cast<int>(asked.size()) * 2 / 3);
  for (const int count : positive) EXPECT_GT(count, static_cast<int>(asked.size()) / 3);
}

std::string refusal(const auto& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CSource, GivesTheBitsOfPredict) {
  const scratch::Folder folder("c_source");
  const Model model = mixed::model();
  base::write_whole(folder / "model.c", surrogate::c_source(model, "bitrock"));
  ASSERT_TRUE(shell(c99 + "-DBITROCK_MAIN " + quoted(folder / "model.c") + "-o " + quoted(folder / "c") + "-lm"));
  const std::vector<CutConditions> asked = questions(model, 1000);
  expect_predicted(model, asked, answers(folder, "c", asked));
}

TEST(CSource, IsCppToo) {
  const scratch::Folder folder("c_source_cpp");
  const Model model = mixed::model();
  base::write_whole(folder / "model.cpp", surrogate::c_source(model, "bitrock"));
  ASSERT_TRUE(shell(cpp + "-DBITROCK_MAIN " + quoted(folder / "model.cpp") + "-o " + quoted(folder / "cpp")));
  const std::vector<CutConditions> asked = questions(model, 100);
  expect_predicted(model, asked, answers(folder, "cpp", asked));
}

TEST(CSource, CountsAsInsideWhatPredictCountsAsInside) {
  // At the bounds, half and twice the slack of the unit conversions outside them.
  const scratch::Folder folder("c_source_bounds");
  const Model model = mixed::model();
  base::write_whole(folder / "model.c", surrogate::c_source(model, "bitrock"));
  ASSERT_TRUE(shell(c99 + "-DBITROCK_MAIN " + quoted(folder / "model.c") + "-o " + quoted(folder / "c") + "-lm"));
  const double deep = 5e-3;
  const std::vector<CutConditions> asked{
      {1.0, deep, 0.3}, {1.0, deep * (1 + 5e-10), 0.3}, {1.0, deep * (1 + 2e-9), 0.3}};
  const std::vector<Answer> given = answers(folder, "c", asked);
  ASSERT_EQ(given.size(), 3U);
  EXPECT_TRUE(given[0].inside);
  EXPECT_TRUE(given[1].inside);
  EXPECT_FALSE(given[2].inside);
}

TEST(CSource, TwoModelsLiveInOneProgram) {
  const scratch::Folder folder("c_source_two");
  const Model first = mixed::model(), second = mixed::model(2);
  base::write_whole(folder / "first.c", surrogate::c_source(first, "first"));
  base::write_whole(folder / "second.c", surrogate::c_source(second, "second_rock"));
  const std::string body =
      "#include <stdio.h>\nint main(void) {\n  const double at[3] = {1.0, 0.002, 0.3};\n  double a[10], b[10];\n"
      "  if (!first_predict(at, a) || !second_rock_predict(at, b)) return 1;\n"
      "  printf(\"%.17g %.17g\\n\", a[first_x_amean_N_per_m], b[second_rock_y_np4_per_m]);\n  return 0;\n}\n";
  base::write_whole(folder / "both.c", "#include \"first.c\"\n#include \"second.c\"\n" + body);
  ASSERT_TRUE(shell(c99 + quoted(folder / "both.c") + "-o " + quoted(folder / "both") + "-lm"));
  ASSERT_TRUE(shell(quoted(folder / "both") + ">" + quoted(folder / "answered")));
  const CutConditions at{1.0, 0.002, 0.3};
  EXPECT_EQ(
      base::read_whole(folder / "answered"),
      fmt::format("{:.17g} {:.17g}\n", surrogate::predict(first, at).x.amean, surrogate::predict(second, at).y.np4));
  ASSERT_TRUE(shell(c99 + "-c " + quoted(folder / "first.c") + "-o " + quoted(folder / "first.o")));
  ASSERT_TRUE(shell("nm -g --defined-only " + quoted(folder / "first.o") + ">" + quoted(folder / "names")));
  const std::string names = base::read_whole(folder / "names");
  EXPECT_EQ(std::count(names.begin(), names.end(), '\n'), 1) << "other files see more than first_predict:\n" << names;
}

TEST(CSource, SurvivesAnyName) {
  const scratch::Folder folder("c_source_names");
  Model model = mixed::model();
  for (const char* rock : {"*/ int x; /*", "line\nbreak\r\n#error", "trigraph ?\?/\nend", "back\\",
                           "\"quote\" 'n' %s {}", "Grauwacke, k\xc3\xb6rnig \xe2\x80\xae turned", "PREFIX_predict"}) {
    model.rock = model.provenance.data_file = rock;
    base::write_whole(folder / "model.c", surrogate::c_source(model, "bitrock"));
    EXPECT_TRUE(shell(c99 + "-fsyntax-only " + quoted(folder / "model.c"))) << rock;
  }
}

TEST(CSource, RefusesAPrefixThatIsNoIdentifier) {
  const Model model = mixed::model();
  for (const char* prefix : {"", "1rock", "_rock", "rock_", "my__rock", "my-rock", "my rock", "k\xc3\xb6rnig", "a;b",
                             "a_name_of_24_characters_"}) {
    EXPECT_NE(refusal([&] { surrogate::c_source(model, prefix); }).find("must be letters, digits"), std::string::npos)
        << prefix;
  }
  EXPECT_EQ(refusal([&] { surrogate::c_source(model, "a_name_of_23_characters"); }), "accepted");
}

TEST(MatlabSource, GivesTheBitsOfPredictInOctave) {
  if (!base::is_installed("octave-cli")) GTEST_SKIP() << "no octave-cli (package octave)";
  const scratch::Folder folder("matlab_source");
  Model model = mixed::model();
  model.rock = "*/ %} ... \nend\n";
  base::write_whole(folder / "model.m", surrogate::matlab_source(model, "model"));
  base::write_whole(
      folder / "main.m",
      "asked = load('asked');\nfor row = 1:size(asked, 1)\n  [statistics, inside] = model(asked(row, :));\n"
      "  printf('%.17g ', statistics);\n  printf('%d\\n', inside);\nend\n");
  base::write_whole(folder / "program", "cd $(dirname $0) && octave-cli --no-init-file main.m\n");
  std::filesystem::permissions(folder / "program", std::filesystem::perms::owner_all);
  const std::vector<CutConditions> asked = questions(model, 60);
  expect_predicted(model, asked, answers(folder, "program", asked));
}

TEST(MatlabSource, AnswersARowForEachRowInOctave) {
  if (!base::is_installed("octave-cli")) GTEST_SKIP() << "no octave-cli (package octave)";
  const scratch::Folder folder("matlab_rows");
  base::write_whole(folder / "model.m", surrogate::matlab_source(mixed::model(), "model"));
  base::write_whole(
      folder / "main.m",
      "many = [0.5 0.002 0.26; 1 0.003 0.20; NaN 0.002 0.2; 50 0.002 0.2];\n"
      "[got, inside] = model(many);\n"
      "assert(isequal(size(got), [4 10]) && isequal(size(inside), [4 1]));\n"
      "for row = 1:4\n  [right, in] = model(many(row, :));\n"
      "  assert(isequaln(got(row, :), right) && isequal(inside(row), in));\nend\n"
      "assert(isequal(inside', [true true false false]));\n"
      "assert(isequal(model([1; 0.003; 0.2]), got(2, :)));\n"  // a signal of Simulink
      "assert(isequal(size(model(zeros(0, 3))), [0 10]));\n"
      "square = [0.5 1 0.7; 0.002 0.003 0.001; 0.26 0.2 0.3];\n"  // three rows, though they look like columns
      "assert(isequal(size(model(square)), [3 10]));\n"
      "assert(isequal(model(single([1 0.5 0.25])), model([1 0.5 0.25])));\n"
      "assert(isequal(model(int32([1 2 3])), model([1 2 3])));\n"
      "bad = {[], 1, [1 0.002], [1; 0.002], [1 0.002 0.2 7], ones(3, 2), ones(2, 1), ones(2, 3, 2), 'abc', ...\n"
      "       [1i 0.002 0.2], {1, 2, 3}, [true false true]};\n"
      "for k = 1:numel(bad)\n  refused = false;\n  try\n    model(bad{k});\n  catch problem\n"
      "    refused = strcmp(problem.identifier, 'model:conditions');\n  end\n"
      "  assert(refused, sprintf('bad input %d was taken', k));\nend\n"
      "disp('all good');\n");
  ASSERT_TRUE(shell("cd " + quoted(folder.path()) + "&& octave-cli --no-init-file main.m > said 2> errors"))
      << base::read_whole(folder / "errors");
  EXPECT_EQ(base::read_whole(folder / "said"), "all good\n");
}

TEST(CSource, TheProgramRefusesLinesThatAreNotThreeNumbers) {
  const scratch::Folder folder("c_lines");
  base::write_whole(folder / "model.c", surrogate::c_source(mixed::model(), "bitrock"));
  ASSERT_TRUE(shell(c99 + "-DBITROCK_MAIN " + quoted(folder / "model.c") + "-o " + quoted(folder / "c") + "-lm"));
  const auto status = [&](const std::string& line) {
    base::write_whole(folder / "asked", "1 0.002 0.3\n" + line);
    return std::system((quoted(folder / "c") + "<" + quoted(folder / "asked") + ">" + quoted(folder / "answered") +
                        "2>" + quoted(folder / "said"))
                           .c_str());
  };
  EXPECT_EQ(status("  2\t0.003 1e-1 \r\n"), 0);
  EXPECT_EQ(status("2 0.003 0.2"), 0);
  for (const char* bad :
       {"1 0.002\n0.3\n", "1 0.002 0.3 4\n", "1 0.002 0x1\n", "1 0,002 0.3\n", "1e 0.002 0.3\n", "\n", "a b c\n"}) {
    EXPECT_NE(status(bad), 0) << bad;
    EXPECT_EQ(base::read_whole(folder / "said"),
              "line 2 of the input: must be three numbers with blanks between them\n")
        << bad;
  }
}

TEST(MatlabSource, RefusesANameThatIsNoIdentifier) {
  const Model model = mixed::model();
  for (const std::string& name : {std::string("my-rock"), std::string(""), std::string(64, 'a')}) {
    EXPECT_NE(refusal([&] { surrogate::matlab_source(model, name); }).find("function name"), std::string::npos) << name;
  }
  EXPECT_EQ(refusal([&] { surrogate::matlab_source(model, std::string(63, 'a')); }), "accepted");
}

TEST(SourceText, NumbersAreNoWholeNumbers) {
  EXPECT_EQ(surrogate::number_text(1.0), "1.0");
  EXPECT_EQ(surrogate::number_text(-12.0), "-12.0");
  EXPECT_EQ(surrogate::number_text(0.1), "0.1");
  EXPECT_EQ(surrogate::number_text(1e300), "1e+300");
}

TEST(Columns, AreSi) {
  const auto columns = surrogate::condition_columns(mixed::model());
  EXPECT_EQ(columns[1].name, "depth_of_cut_m");
  EXPECT_DOUBLE_EQ(columns[1].low, 0.5e-3);
  EXPECT_DOUBLE_EQ(columns[1].high, 5e-3);
  EXPECT_EQ(columns[2].unit, "rad");
  EXPECT_DOUBLE_EQ(columns[2].high, 40.0 * std::acos(-1.0) / 180.0);
}

#if BITROCK_ONNX
TEST(OnnxFile, TheSameModelGivesTheSameBytes) {
  EXPECT_EQ(surrogate::onnx_file(mixed::model()), surrogate::onnx_file(mixed::model()));
  EXPECT_NE(surrogate::onnx_file(mixed::model()), surrogate::onnx_file(mixed::model(2)));
}

TEST(OnnxFile, RefusesNumbersThatNeedMoreThan32Bits) {
  Model model = mixed::model();
  model.outputs[2].variable.scale = 1e39;
  EXPECT_EQ(refusal([&] { surrogate::onnx_file(model); }),
            "x_np1_per_m/scale = 1e+39 does not fit into the 32-bit numbers of ONNX (1e-45 to 3e38)");
  model = mixed::model();
  model.outputs[3].log_reference = 1e-60;
  EXPECT_NE(refusal([&] { surrogate::onnx_file(model); }).find("x_np23_per_m/log_reference = 1e-60"),
            std::string::npos);
  model = mixed::model();
  model.inputs[0].scale = 1e-60;
  EXPECT_NE(refusal([&] { surrogate::onnx_file(model); }).find("conditions/per_scale"), std::string::npos);
  model = mixed::model();
  model.outputs[0].network.parameters.front() = 1e-60;  // a weight may vanish
  EXPECT_EQ(refusal([&] { surrogate::onnx_file(model); }), "accepted");
}
#else
TEST(OnnxFile, SaysWhatIsMissing) {
  EXPECT_NE(refusal([&] { surrogate::onnx_file(mixed::model()); }).find("libonnx-dev"), std::string::npos);
}
#endif

}  // namespace
