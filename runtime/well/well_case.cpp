#include "runtime/well/well_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/pipe_entry.hpp"

namespace bitrock::runtime {

namespace {

using base::any, base::between, base::zero_or;
using base::deg, base::kN, base::mm, base::ms;

constexpr double most_frames = 1e5;
const base::Range depths = between(0.0, 2e4);  // m; the deepest wells have 15 km

/// One section of which these keys may also be given in units of the oil field.
base::Section in_oilfield_units(base::Section section, const std::vector<std::string>& keys) {
  return base::also_in_oilfield_units({std::move(section)}, keys).front();
}

struct Words {
  std::string top = "split", survey, feed = "rate";
  std::vector<double> depth, inclination, azimuth;
};

base::Section describe_well(WellCase& well, Words& words) {
  return in_oilfield_units(
      {"well",
       {{"survey", &words.survey, 1.0, any(), "survey file, relative to this file; or the three lists here"},
        {"measured_depth_m", &words.depth, 1.0, depths, "of the stations, downwards"},
        {"inclination_deg", &words.inclination, deg, between(0.0, 180.0), "of the stations, from the vertical"},
        {"azimuth_deg", &words.azimuth, deg, between(-360.0, 720.0), "of the stations, from north to east"},
        {"bottom_depth_m", &well.bottom_depth, 1.0, depths, "measured depth of the bottom at the beginning; 0: none"},
        {"frames", &well.frames, 1.0, between(0.0, most_frames),
         "instants, evenly over the run, of which the file keeps the whole string; 0: none"},
        {"top", &words.top, 1.0, any(), "'split': the string gets new segments; 'grow': its top one gets longer"},
        {"bit_gauge_mm", &well.bit_gauge, mm, zero_or(1.0, 2000.0), "diameter with which the bit rubs; 0: it does not"},
        {"mud_added_mass", &well.mud_added_mass, 1.0, any(), "whether mud moves with the pipe across its axis"},
        {"mud_drag_N_s_per_m2", &well.drag_across, 1.0, between(0.0, 1e6), "against motion across the axis, a metre"},
        {"axial_damping_ms", &well.damping.axial, ms, between(0.0, 10.0), "damper over spring, along the pipe"},
        {"shear_damping_ms", &well.damping.shear, ms, between(0.0, 10.0), "across"},
        {"torsional_damping_ms", &well.damping.torsion, ms, between(0.0, 10.0), "in twist"},
        {"bending_damping_ms", &well.damping.bending, ms, between(0.0, 10.0), "in bending"},
        {"every_joint", &well.every_joint, 1.0, any(),
         "whether the loads of every joint are kept, a row a sample after settling, for drill fatigue"}}},
      {"measured_depth_m", "bottom_depth_m", "bit_gauge_mm"});
}

base::Section describe_plan(RigPlan& plan, Words& words, double& answer_time) {
  const base::Range speed = between(1e-4, 10.0), ramp = between(0.0, 1e3);
  return in_oilfield_units(
      {"trip",
       {{"run_in_m", &plan.run_in, 1.0, depths, "pipe that is run in before anything turns"},
        {"speed_m_per_s", &plan.run_in_speed, 1.0, speed, "of that"},
        {"ramp_s", &plan.ramp, 1.0, ramp, "of every change of the feed"},
        {"weight_on_bit_kN", &plan.weight_on_bit, kN, between(0.0, 1e4), "to slack off to; 0: stays off bottom"},
        {"slack_off_m_per_s", &plan.slack_off_speed, 1.0, between(1e-4, 1.0), "speed of that"},
        {"feed", &words.feed, 1.0, any(), "while drilling: 'rate', with the rock; 'autodriller', by the weight on bit"},
        {"autodriller_time_s", &answer_time, 1.0, between(1.0, 1e3), "in which the autodriller answers"}}},
      {"run_in_m", "weight_on_bit_kN"});
}

base::Section describe_hole(HoleSection& hole) {
  return in_oilfield_units(
      {"hole",
       {{"to_depth_m", &hole.to_depth, 1.0, between(1e-3, 2e4), "measured depth of its lower end", true},
        {"diameter_mm", &hole.diameter, mm, between(1.0, 2000.0), "of hole or casing", true},
        {"friction", &hole.friction, 1.0, between(0.0, 10.0), "coefficient, of fast slip", true},
        {"resting_friction", &hole.resting_friction, 1.0, between(0.0, 10.0), "coefficient at rest; 0: the same"},
        {"friction_speed_m_per_s", &hole.slip_speed, 1.0, between(1e-4, 10.0),
         "of slip, at which half of the difference is left"}}},
      {"to_depth_m", "diameter_mm"});
}

base::Section describe_pipe(WellPipe& pipe) {
  return in_oilfield_units(
      {"pipe",
       {{"segment_length_m", &pipe.segment_length, 1.0, between(0.1, 100.0), "of its segments, at most"},
        {"contact_diameter_mm", &pipe.contact_diameter, mm, zero_or(1.0, 2000.0),
         "with which it touches the wall, of tool joints; 0: of the body"},
        {"tool_joint_distance_m", &pipe.tool_joint_distance, 1.0, zero_or(0.5, 100.0),
         "from one tool joint to the next, for drill fatigue; 0: none that stand out"}}},
      {"segment_length_m", "contact_diameter_mm", "tool_joint_distance_m"});
}

base::Section describe_point(StressPoint& point) {
  return in_oilfield_units(
      {"stress_point",
       {{"name", &point.name, 1.0, any(), "for people", true},
        {"above_bit_m", &point.above_bit, 1.0, depths, "along the string", true},
        {"angle_deg", &point.angle, deg, between(0.0, 360.0), "around the pipe, turning with it"}}},
      {"above_bit_m"});
}

void take_stations(const base::ConfigFile& file, const Words& words, WellCase& well) {
  if (!words.survey.empty()) {
    if (!words.depth.empty()) file.refuse("well", "survey", "stands beside measured_depth_m; give one of the two");
    well.survey_file = file.resolve(words.survey);
    return;
  }
  if (words.depth.size() < 2)
    throw base::InputError(file.name() + ": [well] needs a survey, or measured_depth_m of two stations or more");
  if (words.inclination.size() != words.depth.size())
    file.refuse("well", "inclination_deg",
                fmt::format("has {} entries (must have {}, as measured_depth_m)", words.inclination.size(),
                            words.depth.size()));
  if (words.azimuth.size() != words.depth.size())
    file.refuse(
        "well", "azimuth_deg",
        fmt::format("has {} entries (must have {}, as measured_depth_m)", words.azimuth.size(), words.depth.size()));
  for (std::size_t i = 0; i < words.depth.size(); ++i)
    well.stations.push_back({words.depth[i], words.inclination[i], words.azimuth[i]});
}

void refuse_of_two_dimensions(const base::ConfigFile& file) {
  for (const char* table : {"string", "axial", "torsion", "wall"})
    if (file.has(table))
      throw base::InputError(fmt::format("{}: [{}] has no meaning beside [well] (take it out)", file.name(), table));
  const struct {
    const char *table, *key, *why;
  } keys[] = {
      {"top_drive", "hook_load_kN", "is a result beside [well]; give trip.weight_on_bit_kN"},
      {"top_drive", "hoist", "has no meaning beside [well]; [trip] says what the hoist does"},
      {"top_drive", "line_stiffness_N_per_m", "has no meaning beside [well]: the hoist is as stiff as the pipe"},
      {"top_drive", "line_damping_N_s_per_m", "has no meaning beside [well]; give well.axial_damping_ms"},
      {"top_drive", "feed_m_per_h", "has no meaning beside [well]; give trip.feed"},
      {"top_drive", "weight_on_bit_kN", "has no meaning beside [well]; give trip.weight_on_bit_kN"},
      {"top_drive", "slack_off_m_per_s", "has no meaning beside [well]; give trip.slack_off_m_per_s"},
      {"top_drive", "autodriller_time_s", "has no meaning beside [well]; give trip.autodriller_time_s"},
      {"run", "start", "has no meaning beside [well]: the string begins at rest"},
      {"run", "off_bottom_mm", "has no meaning beside [well]; give well.bottom_depth_m"}};
  for (const auto& k : keys)
    if (file.has(k.table, k.key)) file.refuse(k.table, k.key, k.why);
}

/// An autodriller holds the weight that the plan slacks off to, with the stiffness of the string that then hangs there.
void take_feed(const base::ConfigFile& file, const Words& words, WellCase& well) {
  if (words.feed != "rate" && words.feed != "autodriller")
    file.refuse("trip", "feed", "must be one of 'rate', 'autodriller'");
  well.plan.holds_weight = words.feed == "autodriller";
  if (!well.plan.holds_weight && file.has("trip", "autodriller_time_s"))
    file.refuse("trip", "autodriller_time_s", "needs feed = 'autodriller'");
  if (well.plan.holds_weight && well.plan.weight_on_bit == 0.0)
    file.refuse("trip", "feed", "needs the weight that the autodriller holds (weight_on_bit_kN)");
  double compliance = well.plan.run_in / beam_of(well.pipes.front().pipe).axial;
  for (const WellPipe& part : well.pipes) compliance += part.pipe.length / beam_of(part.pipe).axial;
  const PipeSection& top = well.pipes.front().pipe;
  well.plan.pipe_weight = gravity * mass_per_length(top) * (1.0 - well.drill.fluid_density / top.density);
  well.plan.autodriller = autodriller_for(1.0 / compliance, well.autodriller_time, well.plan.slack_off_speed);
}

}  // namespace

const WellPipe& pipe_at(const WellCase& well, double above_bit) {
  double below = 0.0;
  for (std::size_t i = well.pipes.size(); i-- > 1;) {
    below += well.pipes[i].pipe.length;
    if (above_bit < below) return well.pipes[i];
  }
  return well.pipes.front();
}

bool has_well(const std::filesystem::path& file) {
  return base::ConfigFile::read(file).has_table("well");
}

namespace {

/// The keys of the file, without looking at the files they name.
WellCase read_keys(base::ConfigFile& file) {
  if (!file.has_table("well"))
    throw base::InputError(file.name() + ": no [well] (drill modes knows strings without one)");
  WellCase well;
  Words words;
  well.drill = read_common_tables(file);
  refuse_of_two_dimensions(file);
  file.fill(describe_well(well, words));
  file.fill(describe_plan(well.plan, words, well.autodriller_time));
  for (int i = 0; i < file.count("hole"); ++i) file.fill_entry(describe_hole(well.hole.emplace_back()), i);
  for (int i = 0; i < file.count("pipe"); ++i) {
    WellPipe pipe{.pipe = read_pipe(file, i)};
    file.fill_entry(describe_pipe(pipe), i);
    if (pipe.tool_joint_distance > 0.0 && pipe.contact_diameter <= pipe.pipe.outer_diameter)
      throw base::InputError(
          fmt::format("{}: pipe {}: tool_joint_distance_m needs tool joints that stand out "
                      "(contact_diameter_mm above the outer diameter of {:g} mm)",
                      file.name(), i + 1, pipe.pipe.outer_diameter / mm));
    well.pipes.push_back(pipe);
    well.drill.pipes.push_back(pipe.pipe);
  }
  for (int i = 0; i < file.count("stress_point"); ++i)
    file.fill_entry(describe_point(well.stress_points.emplace_back()), i);
  file.refuse_unknown();
  take_stations(file, words, well);
  if (words.top != "split" && words.top != "grow") file.refuse("well", "top", "must be one of 'split', 'grow'");
  well.growth = words.top == "grow" ? Growth::grow : Growth::split;
  if (well.pipes.empty()) throw base::InputError(file.name() + ": a case with [well] needs [[pipe]]");
  if (well.hole.empty()) throw base::InputError(file.name() + ": a case with [well] needs [[hole]]");
  if (well.plan.weight_on_bit > 0.0 && well.bottom_depth == 0.0)
    file.refuse("trip", "weight_on_bit_kN", "needs a bottom (well.bottom_depth_m)");
  take_feed(file, words, well);
  return well;
}

/// What follows from the keys.
void settle(const base::ConfigFile& file, WellCase& well) {
  if (!well.drill.drive.imposes_speed) file.refuse("top_drive", "imposes", "must be 'speed' beside [well]");
  well.plan.rotation = well.drill.drive.rotation;
  well.plan.rotation_ramp = well.drill.drive.ramp;
  if (well.drill.bit_rock.advance_law == AdvanceLaw::imposed)
    well.plan.drilling_speed = well.drill.bit_rock.imposed_advance;
  for (StressPoint& point : well.stress_points) {
    const PipeSection& pipe = pipe_at(well, point.above_bit).pipe;
    point.outer_diameter = pipe.outer_diameter;
    point.inner_diameter = pipe.inner_diameter;
  }
}

}  // namespace

WellCase read_well_case(const std::filesystem::path& path) {
  base::ConfigFile file = base::ConfigFile::read(path);
  WellCase well = read_keys(file);
  complete(file, well.drill);
  settle(file, well);
  return well;
}

WellCase recorded_well_case(std::string_view text, const std::string& name) {
  base::ConfigFile file = base::ConfigFile::from_text(text, name);
  WellCase well = read_keys(file);
  settle(file, well);
  return well;
}

std::string resolved_toml(const WellCase& well) {
  WellCase copy = well;
  Words words{.top = well.growth == Growth::grow ? "grow" : "split"};
  for (const SurveyStation& station : well.stations) {
    words.depth.push_back(station.measured_depth);
    words.inclination.push_back(station.inclination);
    words.azimuth.push_back(station.azimuth);
  }
  words.feed = well.plan.holds_weight ? "autodriller" : "rate";
  base::Section plan = describe_plan(copy.plan, words, copy.autodriller_time);
  if (!well.plan.holds_weight)
    std::erase_if(plan.fields, [](const base::Field& field) { return field.name == "autodriller_time_s"; });
  std::vector<base::Section> sections{describe_well(copy, words), std::move(plan)};
  const auto add_entry = [&sections](base::Section section) {
    section.name = "[" + section.name + "]";  // an array of tables
    sections.push_back(std::move(section));
  };
  for (HoleSection& hole : copy.hole) add_entry(describe_hole(hole));
  for (WellPipe& pipe : copy.pipes) {
    base::Section section = describe(pipe.pipe), of_well = describe_pipe(pipe);
    std::move(of_well.fields.begin(), of_well.fields.end(), std::back_inserter(section.fields));
    add_entry(std::move(section));
  }
  for (StressPoint& point : copy.stress_points) add_entry(describe_point(point));
  return resolved_common_toml(copy.drill, std::move(sections),
                              {"wall", "top_drive.hook_load_kN", "run.start", "run.off_bottom_mm"});
}

std::vector<base::KeyRow> well_keys() {
  WellCase well;
  Words words;
  HoleSection hole;
  WellPipe pipe;
  StressPoint point;
  std::vector<base::Section> sections{describe_well(well, words),
                                      describe_plan(well.plan, words, well.autodriller_time), describe_hole(hole),
                                      describe_pipe(pipe), describe_point(point)};
  for (const std::size_t array : {2, 3, 4}) sections[array].name = "[" + sections[array].name + "]";
  return base::key_rows(sections);
}

}  // namespace bitrock::runtime
