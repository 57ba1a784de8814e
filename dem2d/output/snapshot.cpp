#include "dem2d/output/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "dem2d/output/picture.hpp"
#include "dem2d/tool/cutter.hpp"

namespace dem2d {

namespace {

ConvexPolygon cutter_at_the_end(const RunFile& run) {
  const CutCase& cut = run.cut;
  return cutter_outline({cut.cutter_diameter, cut.cutter_thickness, cut.back_rake}, run.run.frames.back().tip_x,
                        cut.bed_height - cut.depth_of_cut);
}

void annotate(const Picture& picture, const RunFile& run) {
  const CutCase& cut = run.cut;
  const double span = (picture.frame().x_high - picture.frame().x_low) * 1e3;
  const double tick = span > 100.0 ? 20.0 : span > 40.0 ? 10.0 : span > 15.0 ? 5.0 : 1.0;  // [mm]
  picture.font_size(17.0);
  draw_axes(picture, {1e3, tick, "x along the cut [mm]"}, {1e3, tick, "height [mm]"});
  const LegendEntry entries[] = {{rock_fill, false, "rock"},
                                 {chip_fills[0], false, "chips"},
                                 {dust_fill, false, "loose grains"},
                                 {tension_line, true, fmt::format("broken in tension ({})", run.run.cracks_tensile)},
                                 {shear_line, true, fmt::format("broken in shear ({})", run.run.cracks_shear)}};
  draw_legend(picture, entries);
  picture.font_size(20.0);
  picture.use(ink);
  picture.text(picture.frame().left, 32.0,
               fmt::format("{}: {:g} m/s, {:g} mm deep, {:g}\u00b0 back rake, after {:.3g} mm of cut", cut.rock.name,
                           cut.cutter_speed, base::in_units(cut.depth_of_cut, base::mm),
                           base::in_units(cut.back_rake, base::deg), run.run.cut_length * 1e3));
}

}  // namespace

std::string draw_snapshot(const RunFile& run, int width_px) {
  const CutCase& cut = run.cut;
  const double above = std::min(cut.domain_margin, 0.6 * cut.bed_height);  // room for the cutter and flying chips
  const Picture picture = Picture::of_world({.x_low = -0.05 * cut.bed_length,
                                             .y_low = 0.0,
                                             .x_high = 1.02 * cut.bed_length,
                                             .y_high = cut.bed_height + above,
                                             .left = 80.0,
                                             .top = 84.0,
                                             .right = 20.0,
                                             .bottom = 64.0},
                                            width_px);
  const Frame& last = run.run.frames.back();
  const DrawnDiscs discs{last.x, last.y, last.radius, last.id, last.fragment, run.run.discs};
  picture.clipped([&] {
    draw_discs(picture, discs);
    draw_cracks(picture, discs, run.run.cracks);
    draw_polygon(picture, cutter_at_the_end(run), tool_fill);
  });
  annotate(picture, run);
  return picture.png();
}

}  // namespace dem2d
