// What a user does wrong, the exit status it gets and the words that explain it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

const std::string rock = BITROCK_SOURCE_DIR "/campaigns/rocks/start.toml";
const std::string example = BITROCK_SOURCE_DIR "/campaigns/cuts/example.toml";
const std::string bit = BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml";

class Errors : public testing::Test {
 protected:
  const scratch::Folder dir{"errors"};

  std::string file(const std::string& name, const std::string& content) {
    base::write_whole(dir / name, content);
    return (dir / name).string();
  }
  /// The shipped file with one piece of text replaced.
  std::string changed(const std::string& original, const std::string& from, const std::string& to) {
    std::string text = base::read_whole(original);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const std::size_t relative = text.find("\"../rocks/article.toml\"");
    if (relative != std::string::npos) text.replace(relative, 23, "\"" + rock + "\"");
    return file("changed.toml", text);
  }
  static void expect(const std::string& arguments, int status, const std::string& words) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << arguments << "\n" << outcome.text << "\nlacks: " << words;
  }
};

TEST_F(Errors, FlagsAndCommands) {
  expect("", 2, "subcommand");
  expect("dance", 2, "subcommand is required");
  expect("cut", 2, "case is required");
  expect("cut " + example + " --threads 0", 2, "Value 0 not in range");
  expect("--help", 0, "campaign");
  expect("--version", 0, "bitrock 0.");
}

TEST_F(Errors, RockAndCutFiles) {
  expect("specimen /nonexistent.toml -o " + (dir / "s.h5").string(), 2, "/nonexistent.toml");
  expect("specimen " + dir.path().string(), 2, "is a folder");
  expect("specimen " + changed(rock, "porosity", "porsity"), 2, "did you mean porosity?");
  expect("specimen " + changed(rock, "radius_min_mm = 0.5", "radius_min_mm = -0.5"), 2,
         "changed.toml:13: discs.radius_min_mm = -0.5 (must be");
  expect("specimen " + changed(rock, "elements = 2", "elements = \"two\""), 2, "must be a whole number");
  expect("specimen " + changed(rock, "[discs]", "[discs"), 2, "changed.toml:12");
  expect("cut " + changed(example, "depth_of_cut_mm = 2", "depth_of_cut_mm = 30"), 2,
         "at most a third of bed.height_mm = 20");
  expect("cut " + changed(example, "cutter_speed_m_per_s = 0.5", "cutter_speed_m_per_s = nan"), 2,
         "cutter_speed_m_per_s = nan");
  expect("cut " + changed(example, "rock = ", "rack = "), 2, "rock is missing");
}

/// Counts that nobody counted, beside mean forces: the table is doubted, and so is the force on a bit that follows.
TEST_F(Errors, TablesThatAreNotWhatTheySeem) {
  std::string rows =
      "case,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,x_amax_N_per_m,x_amean_N_per_m,x_np1,x_"
      "np23,"
      "x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4\n";
  for (int i = 1; i <= 8; ++i) {
    rows += fmt::format("{},{},{},{},0.06,{},{},1,1,1,{},{},1,1,1\n", i, 0.5 * i, i % 2 + 1, 10 + i % 3 * 10, 900 + i,
                        200 + i, 600 + i, 150 + i);
  }
  const std::string model = (dir / "model.json").string();
  const auto trained = run("train " + file("guessed.csv", rows) + " -o " + model);
  EXPECT_EQ(trained.status, 0) << trained.text;
  for (const char* words : {"guessed.csv: x_amean_N_per_m over depth_of_cut_mm is ", "the peak counts of all rows"})
    EXPECT_NE(trained.text.find(words), std::string::npos) << trained.text << "\nlacks: " << words;
  expect("signal " + bit + " --model " + model + " --rpm 120 --rop-m-per-h 15 --duration-s 1 -o " +
             (dir / "f.csv").string(),
         0, "their counts and heights of peaks do not fit together (take all five numbers from the same records");
}

/// Seconds, not samples.
TEST_F(Errors, ProgressOfASignalIsInSecondsOfIt) {
  expect("signal " + bit +
             " --model " BITROCK_SOURCE_DIR
             "/campaigns/paper240/model.json --rpm 120 --rop-m-per-h 15 "
             "--duration-s 200 -o " +
             (dir / "f.csv").string(),
         0, " of 200 s (");
}

TEST_F(Errors, PlacesThatCannotBeWritten) {
  expect("specimen " + rock + " -o /proc/no/such.h5", 2, "/proc/no");
  expect("cut " + example + " -o " + dir.path().string(), 2, "it is a folder");
  expect("campaign run " BITROCK_SOURCE_DIR "/campaigns/demo.toml --dir /proc/no", 2, "/proc/no");
  const std::string csv = file("force.csv", "time_s,force\n0,0\n1,2\n2,1\n");
  expect("peaks " + csv + " --json /dev/full", 3, "No space left on device");
}

TEST_F(Errors, ForceHistories) {
  expect("peaks " + file("empty.csv", ""), 2, "empty.csv: empty");
  expect("peaks " + file("nan.csv", "time_s,force\n0,0\n1,nan\n2,1\n"), 0, "samples that are not numbers: 1");
  expect("peaks " + file("nan.csv", "time_s,force\n0,nan\n1,nan\n"), 2, "nan.csv: no number in force");
  expect("peaks " + file("nan.csv", "time_s,force\n0,0\nnan,1\n"), 2, "time_s of sample 1 is nan");
  expect("peaks " + file("back.csv", "time_s,force\n0,0\n2,2\n1,1\n"), 2, "time_s falls from 2 to 1 at sample 2");
  expect("peaks " + file("still.csv", "time_s,force\n1,0\n1,2\n1,1\n"), 2, "time_s is 1 in all samples");
  expect("peaks " + file("text.csv", "time_s,force\n0,strong\n"), 2, "'strong' is not a number");
  expect("peaks " + file("tabs.csv", "time_s\tforce\n0\t1\n"), 2, "tabs between the columns");
  expect("peaks " + file("bare.csv", "0,1\n1,2\n"), 2, "bare.csv:1: '0' in the header");
  expect("peaks " + file("comma.csv", "\"Zeit, s\",\"Kraft, N\"\n\"0,1\",\"0,5\"\n") + " --column 'Kraft, N'", 2,
         "comma.csv:2: column Kraft, N: '0,5' is not a number (decimal comma: write 0.5)");
  expect("peaks " + (dir / "comma.csv").string() + " --column Kraft", 2,
         "no column Kraft (there are: \"Zeit, s\", \"Kraft, N\")");
  const std::string good = file("good.csv", "time_s,force\n0,0\n1,2\n2,1\n");
  expect("peaks " + good + " --column farce", 2, "no column farce (there are: time_s, force)");
  expect("peaks " + good + " --parts 0", 2, "--parts");
  expect("peaks " + good + " --parts 1001", 2, "--parts");
  expect("peaks " + file("fake.h5", "not a run"), 2, "not an HDF5 file");
  expect("snapshot " + file("fake.h5", "not a run"), 2, "not an HDF5 file");
}

TEST_F(Errors, TrainingDataAndModels) {
  const std::string header =
      "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,duration_s,x_amax_N_per_m,x_amean_N_"
      "per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4\n";
  const std::string rows =
      "1,1,0.5,2,10,0.05,0.1,3e5,3e4,1,9,59,1e5,2e4,2,8,67\n2,1,1.5,2,10,0.05,0.03,4e5,5e4,2,18,77,2e5,3e4,1,7,83\n3,1,"
      "1.5,4,25,0.05,0.03,3e5,4e4,3,10,70,2e5,2e4,1,7,83\n";
  expect("train " + file("one.csv", header + rows.substr(0, rows.find('\n') + 1)), 2, "one.csv");
  expect("train " + file("hole.csv", header + rows + "4,1,1,3\n"), 2,
         "hole.csv:5: 4 values (the header has 17 columns)");
  expect("train " + file("nan.csv", header + rows + "4,1,nan,2,10,0.05,0.1,3e5,3e4,1,9,59,1e5,2e4,2,8,67\n"), 2,
         "nan.csv:5");
  const std::string model = (dir / "model.json").string();
  std::string same;
  for (int number = 1; number <= 9; ++number) {
    same +=
        std::to_string(number) + ",1,1,2,15,0.05,0.1,3e5,3e4,1,9," + std::to_string(50 + number) + ",1e5,2e4,2,8,67\n";
  }
  for (const char* check : {"", " --check"}) {
    expect("train " + file("same.csv", header + same) + check, 2,
           "same.csv: speed, depth and rake are the same in all");
  }
  expect("train " + file("swapped.csv", header + rows + "4,1,1,2,10,0.05,0.1,3e4,3e5,1,9,59,1e5,2e4,2,8,67\n"), 2,
         "swapped.csv:5: x_amean_N_per_m = 300000 is above x_amax_N_per_m = 30000");
  const auto trained = run("train " + file("good.csv", header + rows) + " -o " + model);
  ASSERT_EQ(trained.status, 0) << trained.text;
  expect("train " + (dir / "good.csv").string() + " --check --layers 3,0,1 -o " + model, 2, "a layer of 0 nodes");
  expect("train " + (dir / "good.csv").string() + " --check --split 1 -o " + model, 2, "--split");
  expect("train " + (dir / "good.csv").string() + " --check --validation nan -o " + model, 2, "validation");
  const std::string whole = base::read_whole(model);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999}) {
    expect("predict " +
               file("half.json", whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())))) +
               " --speed-m-per-s 1 --depth-mm 2 --rake-deg 15",
           2, "half.json");
  }
  expect("predict " + model + " --speed-m-per-s 9 --depth-mm 2 --rake-deg 15", 0, "outside the training range");
  expect("predict " + model + " --speed-m-per-s 9 --depth-mm 2 --rake-deg 15 --strict", 2,
         "outside the training range: cutter_speed_m_per_s 9 (trained 0.5 to 1.5: 750 % of that range above it)");
  expect("predict " + model + " --speed-m-per-s 1 --depth-mm 2 --rake-deg 15 --cut-length-mm 0", 2, "--cut-length-mm");
  expect("signal " + bit + " --model " + model + " --rpm 0 --rop-m-per-h 15 -o " + (dir / "f.csv").string(), 2, "rpm");
  expect("signal " + bit + " --model " + model + " --rpm nan --rop-m-per-h 15 -o " + (dir / "f.csv").string(), 2,
         "rpm");
  EXPECT_FALSE(fs::exists(dir / "f.csv"));
  // 60 rpm and 15 m/h are 4.17 mm a turn; learnt were 2 to 4 mm, and the bit's cutters run at 0.09 to 0.67 m/s
  const auto outside = run("signal " + bit + " --model " + model + " --rpm 60 --rop-m-per-h 15 --duration-s 1 -o " +
                           (dir / "f.csv").string());
  EXPECT_EQ(outside.status, 0) << outside.text;
  EXPECT_NE(outside.text.find("warning: outside the training range"), std::string::npos) << outside.text;
  EXPECT_NE(outside.text.find("depth too low 0 %, too high 100 %"), std::string::npos) << outside.text;
  EXPECT_NE(outside.text.find("depth_of_cut_mm 4.167 (trained 2 to 4: 8.33 % of that range above it)"),
            std::string::npos)
      << outside.text;
}

TEST_F(Errors, OutputsNeverReplaceInputs) {
  const std::string csv = file("force.csv", "time_s,force\n0,0\n1,2\n2,1\n");
  expect("peaks " + csv + " --json " + csv, 2, "would be overwritten");
  expect("cut " + example + " -o " + (dir / "a.h5").string() + " --json " + (dir / "a.h5").string(), 2,
         "would be overwritten");
  expect("cut " + example + " -o ''", 2, "empty file name");
  expect("train " + csv + " -o " + csv, 2, "case");  // read first: it is no training data
}

TEST_F(Errors, NumbersThatAreNone) {
  expect("specimen " + rock + " --width-mm nan", 2, "--width-mm: nan (only finite numbers are allowed)");
  expect("specimen " + rock + " --width-mm 1e300 --check", 2, "must be at least 0.01 and at most 10000");
  expect("specimen " + rock + " --width-mm -1 --check", 2, "must be at least 0.01 and at most 10000");
  expect("specimen " + rock + " --width-mm 9000 --height-mm 9000 --check", 2, "at most 1e+07");
  expect("predict x.json --speed-m-per-s 1 --depth-mm 0.002 --rake-deg 15", 2, "is it in m? Then write 2");
  expect("lab ucs " + rock + " --width-mm 0.05", 2, "too small for discs");
  expect("predict x.json --speed-m-per-s '' --depth-mm 2 --rake-deg 15", 2, "an empty text is not a number");
  expect("train x.csv --seed -1", 2, "must be a whole number in decimal digits, 0 or above");
}

// The library that reads the flags takes most of these for numbers: 010 for eight, 0x2 for two, nan for one in any
// range.
TEST_F(Errors, FlagsHoldDecimalNumbersOnly) {
  const std::string whole = "must be a whole number in decimal digits";
  for (const char* text : {"0x2", "1e3", "2.0", "two", "' 2'", "2,3", "''", "0b1", "99999999999999999999"}) {
    expect(std::string("cut ") + example + " --threads " + text, 2, whole);
    expect(std::string("specimen ") + rock + " --check --seed " + text, 2, whole);
  }
  expect("train x.csv --epochs 99999999999", 2, "--epochs: Value 99999999999 not in range");
  expect("train x.csv --layers 3,0x4,1", 2, whole);
  expect("train x.csv --patience 0x2", 2, whole);
  for (const char* text : {"0x14", "1e", "1e999", "inf", "nan", "'nan(1)'", "0,5", "' 1'", "1d0", "1_0"}) {
    const auto outcome = run(std::string("predict x.json --speed-m-per-s 1 --depth-mm 2 --rake-deg ") + text);
    EXPECT_EQ(outcome.status, 2) << text << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find("--rake-deg: "), std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find("x.json"), std::string::npos) << "taken for a number: " << text << "\n" << outcome.text;
  }
  expect("train x.csv --validation nan", 2, "--validation: nan (only finite numbers are allowed)");
  // Leading zeros mean nothing, also where they would mean something to the library: 0400 is 256 there.
  expect("cut " + example + " --threads 0400", 2, "Value 400 not in range");
  const std::string sized = "specimen " + rock + " --check --width-mm +20 --height-mm 2e1 --seed 010 --json ";
  const std::string json = (dir / "seed.json").string();
  expect(sized + json, 0, "20 x 20 mm");
}

TEST_F(Errors, RangesInFlagsHoldDecimalNumbersOnly) {
  const std::string map = std::string("drill map ") + BITROCK_SOURCE_DIR + "/campaigns/drill/stick_slip.toml --model " +
                          BITROCK_SOURCE_DIR + "/campaigns/paper240/model.json --check ";
  for (const char* text :
       {"1e:2:3", "0x14:30:2", "10:20:3x", "10:20:0x3", "10:nan:3", "10:20", "10:20:3:4", "10,5", "''", "10:20:1e1"}) {
    expect(map + "--hook-load-kN " + text, 2, "write lowest:highest:count");
  }
  for (const char* text : {"1:0x3", "1:3x", "1,x", "1:2:3", "-1:2", "1:1e1", "1:99999999999", "3:1", "1:2000"}) {
    expect(map + "--seeds " + text, 2, "e.g. 1,2,5:10");
  }
  const std::string study = file("study.toml", program::small_study());
  for (const char* text : {"0x1/2", "1/2x", "1", "1/2/3", "0/2", "3/2", "'1 /2'", "-1/2"}) {
    expect("campaign run " + study + " --dir " + (dir / "new").string() + " --shard " + text, 2, "write i/n");
  }
}

TEST_F(Errors, AForceOfTheOtherSignIsWarnedOf) {
  const std::string words = "below 0: the rock's resistance";
  expect("peaks " + file("down.csv", "time_s,Fx_N\n0,0\n1,-20\n2,-3\n3,1\n4,-9\n"), 0, words);
  EXPECT_EQ(run("peaks " + file("up.csv", "time_s,Fx_N\n0,0\n1,20\n2,3\n3,-1\n4,9\n")).text.find(words),
            std::string::npos);
}

TEST_F(Errors, EqualInputsAreRefused) {
  expect("lab ucs " + rock + " --seeds 1,1", 2, "a seed is named twice");
  const std::string text =
      "name = \"short run\"\n[[pipe]]\nlength_m = 150\nouter_diameter_mm = 127\ninner_diameter_mm "
      "= 108.61\n[top_drive]\nrotation_rpm = 60\nhook_load_kN = 25\n[bit]\nfriction_radius_mm = "
      "80\n[run]\nduration_s = 0.1\n";
  const std::string h5 = (dir / "run.h5").string();
  ASSERT_EQ(run("drill run " + file("case.toml", text) + " -o " + h5).status, 0);
  expect("report " + h5 + " " + dir.path().string() + "/./run.h5 -o " + (dir / "r.html").string(), 2,
         "are one file (name each once)");
  EXPECT_FALSE(fs::exists(dir / "r.html"));
}

TEST_F(Errors, ACoreOfFewGrainsIsWarnedOf) {
  expect("lab ucs " + rock + " --width-mm 12 --height-mm 24 --check", 0, "8 of the largest grains");
}

TEST_F(Errors, AFolderOfAnotherStudyIsLeftAlone) {
  const std::string study = file("study.toml", program::small_study());
  fs::create_directories(dir / "camp");
  base::write_whole(dir / "camp" / "study.toml", "another study\n");
  expect("campaign run " + study + " --dir " + (dir / "camp").string(), 2, "holds runs of another study");
  expect("campaign run " + study + " --dir " + (dir / "new").string() + " --shard 3/2", 2, "write i/n");
  expect("campaign collect " + study + " --dir " + (dir / "new").string(), 2, "there is no such folder");
  expect("campaign status " + study + " --dir " + (dir / "new").string(), 2, "there is no such folder");
  expect("campaign submit " + study + " --dir " + (dir / "new").string() + " --dry-run --tasks 3", 0, "3 tasks");
  expect("campaign collect " + study + " --dir " + (dir / "new").string(), 2, "no finished runs");
  expect("report " + (dir / "nothing").string(), 2, "is not a folder");
}

}  // namespace
