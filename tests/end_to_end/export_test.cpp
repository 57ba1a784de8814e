// A trained model taken elsewhere, as a user does it: `export c`, `matlab` and `onnx`, compiled, run and compared with
// `predict`; and what goes wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "surrogate/net/model_file.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/export/mixed_model.hpp"

using namespace bitrock;

namespace {

using program::run;

class Export : public testing::Test {
 protected:
  const scratch::Folder dir{"export"};
  const std::string model = (dir / "model.json").string();

  void SetUp() override { surrogate::write_model(model, mixed::model()); }
  std::string path(const std::string& name) const { return (dir / name).string(); }
  void expect_refusal(const std::string& arguments, const std::string& words) const {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << arguments << "\n" << outcome.text << "\nlacks: " << words;
  }
};

TEST_F(Export, CGivesWhatPredictGives) {
  const auto outcome = run("export c " + model + " --prefix my_rock -o " + path("m.c") + " --json " + path("c.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const nlohmann::json said = program::json(path("c.json"));
  EXPECT_EQ(said["files"], nlohmann::json::array({path("m.c")}));
  EXPECT_EQ(said["conditions"][1]["name"], "depth_of_cut_m");
  EXPECT_EQ(said["statistics"].size(), 10U);
  const std::string compile = std::string(BITROCK_C_COMPILER) + " -std=c99 -ffp-contract=off -DBITROCK_MAIN ";
  ASSERT_EQ(std::system((compile + path("m.c") + " -o " + path("m") + " -lm").c_str()), 0);

  for (const auto& [speed, depth_mm, rake_deg] : {std::tuple{0.1, 0.5, 10.0}, {1.7, 3.3, 22.5}, {5.0, 1.0, 45.0}}) {
    run(fmt::format("predict {} --speed-m-per-s {} --depth-mm {} --rake-deg {} --json {}", model, speed, depth_mm,
                    rake_deg, path("p.json")));
    const nlohmann::json expected = program::json(path("p.json"));
    const double rake = rake_deg * surrogate::radians_per_degree;
    ASSERT_EQ(
        std::system(fmt::format("echo {} {} {} | {} > {}", speed, depth_mm * 1e-3, rake, path("m"), path("a")).c_str()),
        0);
    std::istringstream answer(base::read_whole(path("a")));
    for (const char* axis : {"x", "y"}) {
      for (const char* name : {"amax", "amean", "np1", "np23", "np4"}) {
        double value = -1.0;
        answer >> value;
        EXPECT_NEAR(value, expected[axis][name], 1e-12 * std::abs(value)) << axis << name;
      }
    }
    bool inside = false;
    answer >> inside;
    EXPECT_TRUE(answer);
    EXPECT_EQ(inside, expected["inside_training_range"]);
  }
}

TEST_F(Export, OnnxWritesItsFileOrSaysWhatIsMissing) {
  const auto outcome = run("export onnx " + model + " -o " + path("m.onnx") + " --json " + path("onnx.json"));
  if (outcome.status == 0) {
    EXPECT_EQ(program::json(path("onnx.json"))["files"], nlohmann::json::array({path("m.onnx")}));
    EXPECT_NE(base::read_whole(path("m.onnx")).find("depth_of_cut_m"), std::string::npos);
  } else {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.text.find("libonnx-dev"), std::string::npos) << outcome.text;
    EXPECT_FALSE(std::filesystem::exists(path("m.onnx")));
  }
}

TEST_F(Export, MatlabFunctionIsCalledLikeItsFile) {
  const auto outcome = run("export matlab " + model + " -o " + path("my_rock.m") + " --json " + path("m.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(program::json(path("m.json"))["files"], nlohmann::json::array({path("my_rock.m")}));
  EXPECT_EQ(base::read_whole(path("my_rock.m")).find("function [statistics, inside] = my_rock(conditions)\n"), 0U);
  expect_refusal("export matlab " + model + " -o " + path("my_rock.txt"), "must end in .m");
  expect_refusal("export matlab " + model + " -o " + path("my-rock.m"), "function name 'my-rock' (must be letters");
}

TEST_F(Export, RefusesBadInput) {
  for (const std::string format : {"c", "matlab", "onnx"}) {
    expect_refusal("export " + format + " " + path("none.json"), "none.json");
    const std::string text = base::read_whole(model);
    base::write_whole(path("short.json"), text.substr(0, text.size() / 2));
    expect_refusal("export " + format + " " + path("short.json") + " -o " + path("out"), "cut short");
    base::write_whole(path("old.json"), R"({"format": "bitrock-model", "format_version": 1})");
    expect_refusal("export " + format + " " + path("old.json") + " -o " + path("out"), "format_version = 1");
    expect_refusal("export " + format + " " + model + " -o " + model, "model.json");
    expect_refusal("export " + format + " " + model + " -o " + model + "/out", "model.json");
    expect_refusal("export " + format + " " + model + " -o ''", "empty name");
    EXPECT_FALSE(std::filesystem::exists(path("out")));
  }
  expect_refusal("export c " + model + " -o " + path("out") + " --prefix 2nd", "prefix '2nd' (must be letters");
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

}  // namespace
