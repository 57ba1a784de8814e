// Values over a grid: what the script holds, and that gnuplot, where it is, can draw it.
#include "report/heat_map.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using report::heat_map_script, report::HeatMap, report::PictureFormat;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

HeatMap example() {
  return {.title = "it's a map",
          .x_label = "x [mm]",
          .y_label = "y [kN]",
          .value_label = "v [1]",
          .x = {10, 20, 30},
          .y = {1, 2},
          .value = {0.1, 0.2, 0.3, 0.4, nan, 0.6},
          .value_range = {0.0, 1.0},
          .curves = {{.name = "limit", .x = {10, 30}, .y = {1, 2}},
                     {.name = "here", .x = {20}, .y = {1}, .style = report::Style::markers}},
          .right = {.label = "40 - y", .at_first = 39, .at_last = 38},
          .no_value = "no run"};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(HeatMap, ScriptCarriesItsNumbers) {
  const std::string script = heat_map_script(example(), "map.png", PictureFormat::png);
  EXPECT_TRUE(holds(script, "10 1 0.1\n20 1 0.2\n30 1 0.3\n\n10 2 0.4\n20 2 NaN\n30 2 0.6\n"));
  EXPECT_TRUE(holds(script, "set xrange [5:35]\nset yrange [0.5:2.5]"));  // half a cell beyond the middles
  EXPECT_TRUE(holds(script, "set y2range [39.5:37.5]"));
  EXPECT_TRUE(holds(script, R"(set title "it's a map")"));
  EXPECT_TRUE(holds(script, "title 'no run'"));
  EXPECT_EQ(script, heat_map_script(example(), "map.png", PictureFormat::png));
}

TEST(HeatMap, GreyCellsAreInTheLegendOnlyWhereThereAreAny) {
  HeatMap map = example();
  map.value[4] = 0.5;
  EXPECT_FALSE(holds(heat_map_script(map, "map.png", PictureFormat::png), "no run"));
}

TEST(HeatMap, RefusesWhatIsNoGrid) {
  const auto refused = [](const auto& spoil) {
    HeatMap map = example();
    spoil(map);
    EXPECT_THROW(heat_map_script(map, "map.png", PictureFormat::png), base::InputError);
  };
  refused([](HeatMap& map) { map.x = {1}; });
  refused([](HeatMap& map) { map.y.clear(); });
  refused([](HeatMap& map) { map.value.pop_back(); });
  refused([](HeatMap& map) { map.value_range = {1.0, 1.0}; });
}

TEST(HeatMap, NoNameOfItsPictureIsACommand) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const scratch::Folder folder("heat_map_names");
  for (const std::string& name :
       {std::string("|touch touched;.png"), std::string("<touch touched;.png"), std::string("`touch touched`.png"),
        std::string("-"), std::string("it's @data.png")}) {
    HeatMap map = example();
    map.title = map.x_label = map.value_label = name;
    base::write_whole(folder / "map.gp", heat_map_script(map, name, PictureFormat::png));
    const base::ProgramEnd end = base::run_program({"gnuplot", "map.gp"}, folder.path());
    EXPECT_EQ(end.status, 0) << end.output;
    EXPECT_EQ(end.output, "");
    EXPECT_EQ(base::read_whole(folder / name).substr(1, 3), "PNG") << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "touched")) << name;
  }
}

TEST(HeatMap, GnuplotDrawsIt) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const scratch::Folder folder("heat_map");
  for (const auto& [format, first_bytes] : {std::pair{PictureFormat::png, "\x89PNG"}, {PictureFormat::pdf, "%PDF"}}) {
    const std::string picture = (folder / "map").string() + "." + report::ending(format);
    base::write_whole(folder / "map.gp", heat_map_script(example(), picture, format));
    const base::ProgramEnd end = base::run_program({"gnuplot", (folder / "map.gp").string()});
    EXPECT_EQ(end.status, 0) << end.output;
    EXPECT_EQ(end.output, "");
    EXPECT_EQ(base::read_whole(picture).substr(0, 4), first_bytes);
  }
}

}  // namespace
