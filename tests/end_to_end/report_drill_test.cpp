// `bitrock report` of drill runs as a user calls it: the page, the pictures, what is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/child_process.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Two short runs of one string, shaken by a sinusoid and by noise, and what the first one says of itself.
struct Runs {
  scratch::Folder folder{"report_drill"};
  std::string sinusoid = (folder / "sinusoid.h5").string(), noise = (folder / "noise.h5").string(),
              page = (folder / "page.html").string();
  nlohmann::json summary;

  Runs() {
    for (const std::string source : {"sinusoidal", "noise"}) {
      base::write_whole(folder / "case.toml",
                        "name = \"shaken by " + source +
                            "\"\n[[pipe]]\nlength_m = 150\nouter_diameter_mm = 127\ninner_diameter_mm = 108.61\n"
                            "[top_drive]\nrotation_rpm = 60\nhook_load_kN = 25\n[bit]\nfriction_radius_mm = 80\n"
                            "[excitation]\nsource = \"" +
                            source +
                            "\"\nforce_mean_kN = 1\nforce_deviation_kN = 0.5\ntorque_mean_N_m = 50\n"
                            "torque_deviation_N_m = 20\n[run]\nduration_s = 2\nsettling_s = 0.5\nsample_ms = 5\n");
      const auto outcome =
          run("drill run " + (folder / "case.toml").string() + " --quiet -o " + (source == "noise" ? noise : sinusoid) +
              " --json " + (folder / (source + ".json")).string());
      EXPECT_EQ(outcome.status, 0) << outcome.text;
    }
    summary = program::json(folder / "sinusoidal.json")["summary"];
  }
};

/// The text after `<td ...>` of the row named `name`.
std::string cell_of(const std::string& page, const std::string& name) {
  const std::size_t row = page.find("<td>" + name + "</td>");
  if (row == std::string::npos) return "no row " + name;
  const std::size_t begin = page.find('>', page.find("<td", row + 4)) + 1;
  return page.substr(begin, page.find('<', begin) - begin);
}

TEST(ReportDrill, APageOfOneRunHasItsChaptersAndNumbers) {
  const Runs runs;
  const auto outcome =
      run("report " + runs.sinusoid + " -o " + runs.page + " --json " + (runs.folder / "r.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(program::json(runs.folder / "r.json")["files"][0], runs.page);
  const std::string page = base::read_whole(runs.page);
  for (const char* heading : {"Summary", "Over time", "A closer look", "Spectra", "Orbit"})
    EXPECT_TRUE(holds(page, std::string("\">") + heading + "</h2>")) << heading;
  for (const char* words : {"shaken by sinusoidal", "Welch", "natural frequencies", "Spectrum of bit speed",
                            "Rate of penetration", "(highest - lowest) / (2 mean)"})
    EXPECT_TRUE(holds(page, words)) << words;
  EXPECT_EQ(cell_of(page, "stick-slip severity"), fmt::format("{:.4g}", runs.summary["severity"].get<double>()));
  EXPECT_EQ(cell_of(page, "static weight on bit [kN]"),
            fmt::format("{:.4g}", 1e-3 * runs.summary["static_weight_on_bit_N"].get<double>()));
  const auto& speed = runs.summary["bit_rotation_rpm"];
  EXPECT_EQ(cell_of(page, "bit speed [rpm]"),
            fmt::format("{:.4g} \u00b1 {:.3g}", speed["mean"].get<double>(), speed["sd"].get<double>()));
  EXPECT_EQ(cell_of(page, "questions to networks"), "-");
  EXPECT_TRUE(holds(cell_of(page, "natural, torsion, bit free [Hz]"), ", ")) << "two lumps, two frequencies";
}

TEST(ReportDrill, NoShareOfQuestionsIsAboveAll) {
  // Turning slowly on a bit of steep cutters: most conditions are outside the range of the networks in two ways at
  // once.
  const scratch::Folder folder("report_shares");
  std::string text = base::read_whole(BITROCK_SOURCE_DIR "/campaigns/drill/stick_slip.toml");
  std::string bit = base::read_whole(BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml");
  const auto swap = [](std::string& in, const std::string& from, const std::string& to) {
    ASSERT_NE(in.find(from), std::string::npos) << from;
    for (std::size_t at = 0; (at = in.find(from, at)) != std::string::npos; at += to.size())
      in.replace(at, from.size(), to);
  };
  for (const char* digit : {"1", "2"}) swap(bit, std::string("back_rake_deg = ") + digit, "back_rake_deg = 4");
  swap(text, "../bits/pdc15.toml", "bit.toml");
  swap(text, "../paper240", BITROCK_SOURCE_DIR "/campaigns/paper240");
  swap(text, "duration_s = 30", "duration_s = 2");
  swap(text, "settling_s = 5", "settling_s = 0.5");
  base::write_whole(folder / "bit.toml", bit);
  base::write_whole(folder / "case.toml", text);
  const std::string run_file = (folder / "run.h5").string(), page_file = (folder / "p.html").string();
  const auto drilled = run("drill run " + (folder / "case.toml").string() + " -o " + run_file);
  ASSERT_EQ(drilled.status, 0) << drilled.text;
  ASSERT_EQ(run("report " + run_file + " -o " + page_file).status, 0);
  const std::string page = base::read_whole(page_file);
  double sum = 0.0;
  for (const char* what : {"speed", "depth", "rake"}) {
    const std::string cell =
        cell_of(page, fmt::format("\u2003{} outside what the networks have learnt [% of questions]", what));
    const double share = std::stod(cell);
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 100.0) << what;
    sum += share;
  }
  EXPECT_GT(sum, 100.0) << "one question may be outside in several ways";
}

TEST(ReportDrill, RunsStandSideBySide) {
  const Runs runs;
  const auto outcome = run("report " + runs.sinusoid + " " + runs.noise + " -o " + runs.page);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const std::string page = base::read_whole(runs.page);
  EXPECT_TRUE(holds(page, "<th>sinusoid</th><th>noise</th>"));
  for (const char* words : {"Orbit, sinusoid", "Orbit, noise", "Weight on bit, noise"})
    EXPECT_TRUE(holds(page, words)) << words;
  std::filesystem::create_directory(runs.folder / "other");
  std::filesystem::copy(runs.noise, runs.folder / "other" / "sinusoid.h5");
  const std::string twin = (runs.folder / "other" / "sinusoid.h5").string();
  ASSERT_EQ(run("report " + runs.sinusoid + " " + twin + " -o " + runs.page).status, 0);
  EXPECT_TRUE(holds(base::read_whole(runs.page), "<th>" + twin + "</th>")) << "two of one name keep their folders";
}

TEST(ReportDrill, ACampaignFolderShowsItsDrillRunsAndNetworksThatHaveNotSeenItsCuts) {
  const Runs runs;
  const std::filesystem::path folder = runs.folder / "campaign";
  std::filesystem::create_directories(folder / "drill");
  std::filesystem::copy_file(runs.noise, folder / "drill/noise.h5");
  std::filesystem::copy_file(BITROCK_SOURCE_DIR "/campaigns/paper240/model.json", folder / "earlier_model.json");
  std::filesystem::copy_file(BITROCK_SOURCE_DIR "/campaigns/six_mm/features.csv", folder / "features.csv");
  base::write_whole(folder / "bit_force.csv", "time_s,axial_force_N,torque_N_m\n0,1,2\n0.1,3,4\n0.2,2,3\n");
  const auto outcome = run("report " + folder.string() + " -o " + runs.page);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const std::string page = base::read_whole(runs.page);
  for (const char* words : {"Networks that have not seen these cuts", "earlier_model.json", "held out lie outside",
                            "The drill string: summary", "The drill string: over time", "shaken by noise"})
    EXPECT_TRUE(holds(page, words)) << words;
}

TEST(ReportDrill, AFolderIsReportedWhateverOneThingItHolds) {
  const Runs runs;
  const std::filesystem::path drilled = runs.folder / "drilled", earlier = runs.folder / "earlier",
                              empty = runs.folder / "empty";
  for (const std::filesystem::path& folder : {drilled / "drill", earlier, empty})
    std::filesystem::create_directories(folder);
  std::filesystem::copy_file(runs.noise, drilled / "drill/noise.h5");
  std::filesystem::copy_file(BITROCK_SOURCE_DIR "/campaigns/paper240/model.json", earlier / "earlier_model.json");
  for (const auto& [folder, words] :
       {std::pair{drilled, "The drill string: summary"}, {earlier, "Learning of the earlier networks"}}) {
    const auto outcome = run("report " + folder.string() + " -o " + runs.page);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_TRUE(holds(base::read_whole(runs.page), words)) << words;
  }
  const auto refused = run("report " + empty.string() + " -o " + runs.page);
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(holds(refused.text, "holds nothing to report (looked for runs/*.h5, model.json, earlier_model.json"))
      << refused.text;
}

TEST(ReportDrill, FiguresAreFilesWithScriptAndTable) {
  const Runs runs;
  const bool can_draw = base::is_installed("gnuplot");
  const auto drawn = [&](const std::string& inputs, const std::string& folder, const std::string& format,
                         const std::vector<std::string>& names) {
    const auto outcome =
        run("report " + inputs + " -o " + runs.page + " --quiet --figures " + folder + " --format " + format);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    for (const std::string& name : names) {
      EXPECT_TRUE(std::filesystem::exists(folder + "/" + name + ".gp")) << name;
      EXPECT_TRUE(std::filesystem::exists(folder + "/" + name + ".csv")) << name;
      const std::string picture = folder + "/" + name + "." + format;
      EXPECT_EQ(std::filesystem::exists(picture), can_draw) << name;
      if (can_draw) {
        EXPECT_GT(std::filesystem::file_size(picture), 5000u) << name;
      }
    }
  };
  drawn(runs.sinusoid, (runs.folder / "one").string(), "png",
        {"drill_run", "drill_time", "drill_closer", "drill_spectra", "drill_orbit"});
  drawn(runs.sinusoid + " " + runs.noise, (runs.folder / "two").string(), "pdf",
        {"drill_time", "drill_closer", "drill_spectra", "drill_orbit"});
  EXPECT_FALSE(std::filesystem::exists(runs.folder / "two" / "drill_run.gp")) << "a sheet is of one run";
}

TEST(ReportDrill, WhatIsNoDrillRunEndsWithStatus2AndSaysWhy) {
  const Runs runs;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const auto outcome = run("report " + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.text;
    EXPECT_TRUE(holds(outcome.text, words)) << outcome.text;
  };
  const std::string whole = base::read_whole(runs.noise), to = " -o " + runs.page;
  base::write_whole(runs.folder / "short.h5", whole.substr(0, whole.size() / 2));
  refused((runs.folder / "short.h5").string() + to, "short.h5: no checksum at its end (truncated");
  std::string changed = whole;
  changed[whole.size() / 3] ^= 1;
  base::write_whole(runs.folder / "changed.h5", changed);
  refused(runs.sinusoid + " " + (runs.folder / "changed.h5").string() + to, "changed.h5: damaged");
  refused((runs.folder / "case.toml").string() + to, "not an HDF5 file");
  refused((runs.folder / "nothing.h5").string() + to, "is not a folder or a file");
  refused(runs.noise + " " + runs.folder.path().string() + to, "is a folder");
  refused(runs.noise + " -o " + runs.noise, "noise.h5");
  std::string seven;
  for (int i = 0; i < 7; ++i) seven += runs.noise + " ";
  refused(seven + to, "at most 6");
  refused(runs.folder.path().string() + " --figures " + (runs.folder / "f").string() + to, "--figures");
  EXPECT_FALSE(std::filesystem::exists(runs.page));
  EXPECT_EQ(base::read_whole(runs.noise), whole);
}

}  // namespace
