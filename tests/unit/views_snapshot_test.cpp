// The picture of a cut, read pixel by pixel: what must be drawn where, and what must not yet be there.
#include "views/cut/snapshot.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "tests/unit/output_fixtures.hpp"
#include "views/cut/picture.hpp"
#include "views/cut/png.hpp"

using namespace bitrock;

namespace {

/// A PNG taken apart.
class Pixels {
 public:
  explicit Pixels(std::string png) : png_(std::move(png)) {
    surface_.reset(cairo_image_surface_create_from_png_stream(read, this));
    EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  views::Colour at(int x, int y) const {
    std::uint32_t word = 0;
    std::memcpy(
        &word,
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get()) + 4 * x,
        sizeof word);
    return {(word >> 16 & 255u) / 255.0, (word >> 8 & 255u) / 255.0, (word & 255u) / 255.0};
  }

 private:
  static cairo_status_t read(void* self, unsigned char* data, unsigned int length) {
    auto* pixels = static_cast<Pixels*>(self);
    if (pixels->read_ + length > pixels->png_.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, pixels->png_.data() + pixels->read_, length);
    pixels->read_ += length;
    return CAIRO_STATUS_SUCCESS;
  }
  std::string png_;
  std::size_t read_ = 0;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_{nullptr, cairo_surface_destroy};
};

/// Within two of the 255 steps of each colour.
void expect_colour(const views::Colour& seen, const views::Colour& expected, const std::string& what) {
  EXPECT_NEAR(seen.red, expected.red, 2.0 / 255.0) << what;
  EXPECT_NEAR(seen.green, expected.green, 2.0 / 255.0) << what;
  EXPECT_NEAR(seen.blue, expected.blue, 2.0 / 255.0) << what;
}

// The region shown is -0.5 to 10.2 mm by 0 to 6 mm (2 mm of domain above a bed of 4 mm). With margins of 80 and 20 px
// a page of 1170 px has 100 px for each millimetre, and the rock begins at 84 px.
constexpr int width = 1170;
int px(double x_mm) {
  return static_cast<int>(80 + 100 * (x_mm + 0.5));
}
int py(double y_mm) {
  return static_cast<int>(84 + 100 * (6 - y_mm));
}
// Two panels of 130 px, each 22 px below what stands above it.
constexpr int first_panel = 84 + 600 + 22, page_height = 84 + 600 + 2 * (22 + 130) + 64;

TEST(Snapshot, RockChipCutterAndCracksStandWhereTheyAre) {
  const dem2d::RunFile run = output_fixtures::run();
  const Pixels end(views::draw_snapshot(run, width));
  EXPECT_EQ(end.width(), width);
  EXPECT_EQ(end.height(), page_height);
  expect_colour(end.at(px(6.0), py(1.0)), views::rock_fill, "a disc of the bed");
  expect_colour(end.at(px(8.2), py(3.0)), views::chip_fills[2], "the chip whose lowest disc is 2");
  expect_colour(end.at(px(3.5), py(4.5)), views::tool_fill, "the cutter, 1 mm thick behind its tip at 4 mm");
  expect_colour(end.at(px(6.5), py(1.0)), views::tension_line, "the crack within the bed");
  expect_colour(end.at(px(8.5), py(3.0)), views::shear_line, "the crack within the chip");
  expect_colour(end.at(px(6.6), py(1.9)), {1, 1, 1}, "no crack where bed and chip have parted");
}

TEST(Snapshot, AFrameShowsItsOwnInstant) {
  const dem2d::RunFile run = output_fixtures::run();
  const Pixels frame(views::draw_snapshot(run, output_fixtures::frame_at(2e-3, 2e-3), width));
  expect_colour(frame.at(px(1.5), py(4.5)), views::tool_fill, "the cutter behind its tip at 2 mm");
  expect_colour(frame.at(px(3.5), py(4.5)), {1, 1, 1}, "the cutter has not come here");
  expect_colour(frame.at(px(6.5), py(1.0)), views::tension_line, "a crack of 1 ms at 2 ms");
  EXPECT_GT(frame.at(px(8.5), py(3.0)).green, 0.3) << "a crack of 3 ms at 2 ms";
}

TEST(Snapshot, TheForceStandsBelowThePlaceOfTheTip) {
  const dem2d::RunFile run = output_fixtures::run();
  const Pixels frame(views::draw_snapshot(run, output_fixtures::frame_at(2e-3, 2e-3), width)),
      end(views::draw_snapshot(run, width));
  // from 0 to 4 kN/m, with 3 % below and 6 % above: where 1 and 3 kN/m stand, when the tip was at 1 and 3 mm
  const auto height_of = [](double force) { return first_panel + 130 * (4240 - force) / 4360; };
  const auto colour_at = [&](const Pixels& picture, double force) {
    return picture.at(px(force / 1000), static_cast<int>(height_of(force)));
  };
  EXPECT_LT(colour_at(end, 1000).red, 0.45) << "blue";
  EXPECT_LT(colour_at(end, 3000).red, 0.45);
  EXPECT_LT(colour_at(frame, 1000).red, 0.45);
  EXPECT_GT(colour_at(frame, 3000).red, 0.6) << "pale: later than the frame";
  EXPECT_LT(colour_at(frame, 3000).red, 0.97) << "but there";
  EXPECT_LT(frame.at(px(2.0), first_panel + 20).red, 0.5) << "the marker of the instant";
  expect_colour(end.at(px(2.0), first_panel + 20), {1, 1, 1}, "no marker at the end");
  expect_colour(end.at(px(4.0), first_panel + 100), {1, 1, 1}, "no marker at the end");
}

TEST(Snapshot, ThePageFollowsTheBed) {
  dem2d::RunFile run = output_fixtures::run();
  run.cut.bed_height = 0.5e-3;  // long and flat: 0.12 lengths above the bed
  run.cut.depth_of_cut = 0.1e-3;
  EXPECT_NEAR(Pixels(views::draw_snapshot(run, width)).height(), page_height - 600 + 170, 1);
  run.cut.bed_height = 40e-3;  // higher than long: a square
  EXPECT_NEAR(Pixels(views::draw_snapshot(run, width)).height(), page_height - 600 + 1070, 1);
  const Pixels narrow(views::draw_snapshot(output_fixtures::run(), 450));
  EXPECT_EQ(narrow.width(), 450);
  // drawn 900 px wide, then reduced to a half: 800 px for 10.7 mm
  EXPECT_NEAR(narrow.height(), 0.5 * (page_height - 600 + 6 * 800 / 10.7), 1);
}

TEST(Snapshot, ForcesThatAreAllZeroAndLongNamesAreDrawn) {
  dem2d::RunFile run = output_fixtures::run();
  run.run.force_x.assign(4, 0.0);
  run.run.force_y.assign(4, -5.0);
  run.cut.rock.name = std::string(300, 'm');
  const Pixels end(views::draw_snapshot(run, width));
  for (int y = 0; y < 60; ++y) expect_colour(end.at(width - 10, y), {1, 1, 1}, "the title stays on the page");
}

TEST(Ticks, OneTwoFive) {
  EXPECT_DOUBLE_EQ(views::tick_of(64.0), 10.0);
  EXPECT_DOUBLE_EQ(views::tick_of(99.0), 10.0);
  EXPECT_DOUBLE_EQ(views::tick_of(101.0), 20.0);
  EXPECT_DOUBLE_EQ(views::tick_of(0.3), 0.05);
  EXPECT_DOUBLE_EQ(views::tick_of(450.0, 2), 200.0);
  for (double span = 1e-3; span < 1e6; span *= 1.37) {
    EXPECT_GE(span / views::tick_of(span), 5.0 - 1e-9);
    EXPECT_LE(span / views::tick_of(span), 12.5 + 1e-9);
  }
}

TEST(Snapshot, CutsThatAreComparedHaveOneScaleOfForce) {
  std::vector<dem2d::RunFile> runs{output_fixtures::run(), output_fixtures::run()};
  for (double& force : runs[1].run.force_x) force *= 3.0;
  for (double& force : runs[1].run.force_y) force = -std::abs(force) - 1.0;
  const auto most = [](const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); };
  const views::ForceScale scale = views::force_scale(runs);
  EXPECT_EQ(scale.high_x, most(runs[1].run.force_x));
  EXPECT_EQ(scale.high_y, std::max(0.0, most(runs[0].run.force_y)));
  EXPECT_LT(scale.low_y, -1.0);
  EXPECT_EQ(views::force_scale({}).high_x, 0.0);
}

TEST(Snapshot, PicturesStandOneBelowTheOtherOnWhite) {
  const auto page = [](int pixels, const views::Colour& colour) {
    const views::Picture picture = views::Picture::of_curves({0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0}, pixels, 40);
    picture.use(colour);
    cairo_paint(picture.cairo());
    return picture.png();
  };
  const std::string pages[] = {page(900, views::blue_line), page(1000, views::orange_line)};
  const Pixels both(views::stacked(pages));
  EXPECT_EQ(both.width(), 1000);
  EXPECT_EQ(both.height(), 80);
  expect_colour(both.at(450, 20), views::blue_line, "the first");
  expect_colour(both.at(950, 20), {1.0, 1.0, 1.0}, "beside it");
  expect_colour(both.at(950, 60), views::orange_line, "the second");
}

}  // namespace
