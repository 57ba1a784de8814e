#include "runtime/drillstring/drill_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/pipe_entry.hpp"
#include "runtime/drillstring/top_drive_keys.hpp"

namespace bitrock::runtime {

namespace {

using base::any, base::between, base::zero_or;
using base::deg, base::kN, base::m_per_h, base::mm, base::mm2, base::MPa, base::ms, base::rpm;

constexpr double most_samples = 1e7;  // 80 MB for each recorded quantity
constexpr double most_steps = 1e9;    // an hour or two of one core

// Ranges, in the unit of the key: about ten times beyond what there is, down to rigs on a laboratory bench and up to
// the deepest wells; near enough to catch a slipped unit.
const base::Range arm = zero_or(1.0, 2000.0);  // mm
const base::Range force = between(0.0, 1e5);   // kN; the strongest rigs carry 12,000
const base::Range ratio_of_forces = between(0.0, 10.0);
const base::Range mass = between(1e-3, 1e7), inertia = between(1e-6, 1e6);                       // kg, kg m2: of a lump
const base::Range axial_spring = between(1.0, 1e13), axial_damper = between(0.0, 1e10);          // N/m, N s/m
const base::Range torsional_spring = between(1e-3, 1e10), torsional_damper = between(0.0, 1e8);  // N m/rad, N m s/rad
const base::Range bit_mass = between(0.0, 1e5), bit_inertia = between(0.0, 1e5);  // kg, kg m2; with its motor
const base::Range torque = between(0.0, 1e7);                                     // N m; ten times the top drive's
const base::Range duration = between(1e-3, 1e6), pause = between(0.0, 1e6);       // s; 1e6 s are eleven days

/// Words of the file on their way to enumerations.
struct Words {
  std::string lumping = "middle", imposes = "speed", jets = "up", friction = "smooth", wall = "none", advance = "root";
  std::string unloading = "free", axial_source = "full", source = "none", start = "turning", control = "stiff";
  std::string hoist = "load";
};

template <class Enum, std::size_t n>
using Meanings = std::array<std::pair<const char*, Enum>, n>;

constexpr Meanings<Lumping, 2> lumpings{{{"middle", Lumping::middle}, {"end", Lumping::end}}};
constexpr Meanings<bool, 2> imposed{{{"speed", true}, {"torque", false}}};
constexpr Meanings<DriveAnswer, 3> drive_answers{
    {{"stiff", DriveAnswer::stiff}, {"soft_torque", DriveAnswer::soft_torque}, {"matched", DriveAnswer::matched}}};
constexpr Meanings<HoistRule, 3> hoist_rules{
    {{"load", HoistRule::load}, {"feed", HoistRule::feed}, {"autodriller", HoistRule::autodriller}}};
constexpr Meanings<bool, 2> directions{{{"up", true}, {"down", false}}};
constexpr Meanings<FrictionLaw, 3> friction_laws{
    {{"none", FrictionLaw::none}, {"smooth", FrictionLaw::smooth}, {"stribeck", FrictionLaw::stribeck}}};
constexpr Meanings<AdvanceLaw, 4> advance_laws{{{"none", AdvanceLaw::none},
                                                {"root", AdvanceLaw::root},
                                                {"regularized", AdvanceLaw::regularized},
                                                {"imposed", AdvanceLaw::imposed}}};
constexpr Meanings<Unloading, 2> unloadings{{{"free", Unloading::free}, {"elastic", Unloading::elastic}}};
constexpr Meanings<AxialSource, 3> axial_sources{
    {{"full", AxialSource::full}, {"fluctuation", AxialSource::fluctuation}, {"none", AxialSource::none}}};
constexpr Meanings<SourceKind, 4> sources{{{"none", SourceKind::none},
                                           {"sinusoidal", SourceKind::sinusoidal},
                                           {"noise", SourceKind::noise},
                                           {"bit", SourceKind::bit}}};
constexpr Meanings<bool, 2> starts{{{"turning", true}, {"rest", false}}};

template <class Enum, std::size_t n>
Enum meaning_of(const base::ConfigFile& file, const char* section, const char* key, const std::string& word,
                const Meanings<Enum, n>& meanings) {
  std::string allowed;
  for (const auto& [name, value] : meanings) {
    if (word == name) return value;
    allowed += fmt::format("{}'{}'", allowed.empty() ? "" : ", ", name);
  }
  file.refuse(section, key, "must be one of " + allowed);
}

template <class Enum, std::size_t n>
std::string word_of(Enum value, const Meanings<Enum, n>& meanings) {
  for (const auto& [name, meaning] : meanings) {
    if (meaning == value) return name;
  }
  return "";
}

base::Section describe_string(DrillCase& drill, Words& words) {
  const base::Range ratio = between(0.0, 1.0), lumps = between(1, 200);
  return {"string",
          {{"axial_lumps", &drill.axial_lumps, 1.0, lumps, "masses the string is cut into"},
           {"torsional_lumps", &drill.torsional_lumps, 1.0, lumps, "inertias the string is cut into"},
           {"lumping", &words.lumping, 1.0, any(), "where a lump sits in its stretch: 'middle' or 'end'"},
           {"axial_damping_ratio", &drill.axial_damping_ratio, 1.0, ratio, "of each pair: c = 2 zeta sqrt(K m)"},
           {"torsional_damping_ratio", &drill.torsional_damping_ratio, 1.0, ratio, "of each pair"}}};
}

base::Section describe_axial(Chain& chain) {
  return {"axial",
          {{"mass_kg", &chain.inertia, 1.0, mass, "of each lump, from top to bottom"},
           {"stiffness_N_per_m", &chain.stiffness, 1.0, axial_spring, "of the springs between them: one less"},
           {"damping_N_s_per_m", &chain.damping, 1.0, axial_damper, "of the dampers beside the springs"}}};
}

base::Section describe_torsion(Chain& chain) {
  return {"torsion",
          {{"inertia_kg_m2", &chain.inertia, 1.0, inertia, "of each lump, from top to bottom"},
           {"stiffness_N_m_per_rad", &chain.stiffness, 1.0, torsional_spring, "of the spring above each lump"},
           {"damping_N_m_s_per_rad", &chain.damping, 1.0, torsional_damper, "of the damper beside each spring"}}};
}

base::Section describe_friction(const char* name, Friction& friction, std::string& law) {
  const base::Range shape = between(0.0, 1000.0), time = between(0.0, 1000.0);  // published humps have shapes below 10
  return {name,
          {{"law", &law, 1.0, any(), "'none', 'smooth' or 'stribeck'"},
           {"mu0", &friction.smooth.mu0, 1.0, ratio_of_forces, "smooth: scale"},
           {"alpha_s", &friction.smooth.alpha, 1.0, shape, "smooth: hump"},
           {"beta", &friction.smooth.beta, 1.0, shape, "smooth: end of the hump, speeds in rad/s"},
           {"gamma", &friction.smooth.gamma, 1.0, between(0.5, 10.0), "smooth: fall of the hump"},
           {"nu_s", &friction.smooth.nu, 1.0, ratio_of_forces, "smooth: viscous share"},
           {"resting", &friction.stribeck.resting, 1.0, ratio_of_forces, "stribeck: coefficient at rest"},
           {"sliding", &friction.stribeck.sliding, 1.0, ratio_of_forces, "stribeck: coefficient at high speed"},
           {"decay_s", &friction.stribeck.decay, 1.0, time, "stribeck: fall from one to the other"}}};
}

/// What drives the string, and the bit with its frictions.
std::vector<base::Section> describe_operation(DrillCase& drill, Words& words) {
  const base::Range speed = zero_or(0.01, 500.0), drive_torque = between(0.0, 1e3);  // top drives give 120 kN m
  base::Section wall = describe_friction("wall", drill.wall_friction, words.wall);
  wall.fields.push_back({"normal_force_kN", &drill.wall_force, kN, force, "of the wall on each torsional lump"});
  wall.fields.push_back({"radius_mm", &drill.wall_radius, mm, arm, "arm of that friction"});
  return {
      {"",
       {{"name", &drill.name, 1.0, any(), "for people", true},
        {"rock", &drill.rock, 1.0, any(), "of the case; a model of another one is warned of"}}},
      {"top_drive",
       {{"imposes", &words.imposes, 1.0, any(), "'speed' or 'torque'"},
        {"rotation_rpm", &drill.drive.rotation, rpm, speed, "imposed speed"},
        {"torque_kN_m", &drill.drive.torque, kN, drive_torque, "imposed torque"},
        {"ramp_s", &drill.drive.ramp, 1.0, pause, "time to full speed or torque; 0: at once"},
        {"hook_load_kN", &drill.drive.hook_load, kN, force, "upward force on the top of the string"},
        {"inertia_kg_m2", &drill.drive_inertia, 1.0, between(0.0, 1e6),
         "of a drive that imposes torque, or has soft torque (0: 2900)"},
        {"damping_N_m_s_per_rad", &drill.drive_damping, 1.0, torsional_damper, "of a drive that imposes torque"},
        {"control", &words.control, 1.0, any(),
         "how the drive answers to the string: 'stiff', 'soft_torque' or 'matched'"},
        {"control_damping_N_m_s_per_rad", &drill.control.damping, 1.0, torsional_damper,
         "gain of that control; 0: by the impedance of the string"},
        {"control_period_s", &drill.control.period, 1.0, zero_or(1e-3, 1e3),
         "of the vibration it is tuned to; 0: the slowest of the string"},
        {"reaction_time_ms", &drill.control.reaction_time, ms, between(0.1, 1e3),
         "matched: how late the drive follows"},
        {"hoist", &words.hoist, 1.0, any(),
         "what holds the string: 'load', the hook load; 'feed' or 'autodriller', a block that goes down"},
        {"line_stiffness_N_per_m", &drill.hoist.stiffness, 1.0, zero_or(1.0, 1e13),
         "of drill line and derrick, between block and string"},
        {"line_damping_N_s_per_m", &drill.hoist.damping, 1.0, axial_damper, "of the damper beside that spring"},
        {"feed_m_per_h", &drill.hoist.feed, m_per_h, between(0.0, 1000.0), "feed: speed of the block"},
        {"weight_on_bit_kN", &drill.hoist.weight_on_bit, kN, between(0.0, 1e4),
         "autodriller: held; feed: at the beginning, 0: with which the rock goes away as fast"},
        {"slack_off_m_per_s", &drill.hoist.autodriller.fastest, 1.0, between(1e-4, 1.0),
         "autodriller: fastest speed of the block"},
        {"autodriller_time_s", &drill.autodriller_time, 1.0, between(1.0, 1e3), "in which the autodriller answers"}}},
      {"bit",
       {{"file", &drill.bit_file, 1.0, any(), "bit file, relative to this file; or the keys of a bit here"},
        {"mass_kg", &drill.bit_mass, 1.0, bit_mass, "added to the lowest axial lump"},
        {"inertia_kg_m2", &drill.bit_inertia, 1.0, bit_inertia, "added to the lowest inertia; 0: of a cylinder"},
        {"damping_N_m_s_per_rad", &drill.bit_damping, 1.0, torsional_damper, "against the ground"},
        {"friction_radius_mm", &drill.bit_rock.friction_radius, mm, arm, "arm; 0: mean radius of the cutters"}}},
      describe_friction("friction", drill.bit_rock.friction, words.friction),
      wall,
  };
}

/// How the bit drills and what rock and fluid do to it.
std::vector<base::Section> describe_bit_rock(DrillCase& drill, Words& words) {
  BitRock& rock = drill.bit_rock;
  RootAdvance& root = rock.root_advance;
  RegularizedAdvance& regularized = rock.regularized_advance;
  // 1e-5 at 1 kN and 60 rpm are 90 m/h; the regularized constants at 1e3 times those that are known.
  const base::Range c1 = between(0.0, 1e-5), a1 = between(0.0, 5.0), a2 = between(0.0, 1e-4), a3 = between(0.0, 0.1);
  const base::Range weight = between(0.0, 1e4);  // kN; the largest bits bear 500
  const base::Range lift = zero_or(0.01, 100.0), averaging = between(1e-3, 100.0);
  const base::Range pressure = between(0.0, 500.0), nozzles = zero_or(1.0, 1e5);  // ten times pumps and nozzles
  const base::Range density = zero_or(10.0, 3000.0);  // a gas carries nothing, mud has 1000 to 2200
  return {
      {"drilling",
       {{"law", &words.advance, 1.0, any(), "'root', 'regularized', 'imposed' or 'none'"},
        {"c1_m_per_s_per_N_per_sqrt_rad_per_s", &root.c1, 1.0, c1, "root: C1"},
        {"c2_m_per_s", &root.c2, 1.0, between(-1.0, 0.0), "root: C2"},
        {"a1_m_per_s", &regularized.a1, 1.0, a1, "regularized: a1"},
        {"a2_m_per_s_per_N", &regularized.a2, 1.0, a2, "regularized: a2"},
        {"a3_m_per_rad", &regularized.a3, 1.0, a3, "regularized: a3"},
        {"imposed_rop_m_per_h", &rock.imposed_advance, m_per_h, between(0.0, 1000.0), "imposed: of a bit that turns"},
        {"threshold_weight_kN", &rock.threshold_weight, kN, weight, "weight that does not yet drill"},
        {"imposed_weight_kN", &rock.imposed_weight, kN, weight, "weight on bit without an axial chain"}}},
      {"bit_rock",
       {{"stiffness_N_per_m", &rock.contact.stiffness, 1.0, axial_spring, "under the bit"},
        {"damping_N_s_per_m", &rock.contact.damping, 1.0, axial_damper, "under the bit"},
        {"fracture_stiffness_N_m_per_rad", &rock.fracture_stiffness, 1.0, torsional_spring, "before the cutters"},
        {"unloading", &words.unloading, 1.0, any(), "of that spring when the bit turns back: 'free' or 'elastic'"},
        {"axial_source", &words.axial_source, 1.0, any(), "'full', 'fluctuation' or 'none'"},
        {"engagement_depth_mm", &rock.engagement_depth, mm, lift, "lift at which cutters are out of the rock"},
        {"averaging_time_s", &rock.averaging_time, 1.0, averaging, "of rotation and ROP before the source"}}},
      {"fluid",
       {{"pressure_drop_MPa", &drill.pressure_drop, MPa, pressure, "over the bit"},
        {"nozzle_area_mm2", &drill.nozzle_area, mm2, nozzles, "of all nozzles"},
        {"jet_force", &words.jets, 1.0, any(), "'up' or 'down'"},
        {"density_kg_per_m3", &drill.fluid_density, 1.0, density, "around the pipes"}}},
  };
}

std::vector<base::Section> describe_run(DrillCase& drill, Words& words) {
  const base::Range seed = between(-1, 2147483647), waves = between(1e-3, 1e4);
  const base::Range step = between(1e-6, 1e3), sample = between(1e-6, 1e9);  // ms
  const base::Range lift = zero_or(0.01, 1e5);                               // mm
  return {
      {"excitation",
       {{"source", &words.source, 1.0, any(), "'none', 'sinusoidal', 'noise' or 'bit'"},
        {"model", &drill.source.model_file, 1.0, any(), "bit: model.json, relative to this file"},
        {"seed", &drill.source.seed, 1.0, seed, "noise, bit: of the draws; -1: that of the bit file, or 1"},
        {"force_mean_kN", &drill.source.force.mean, kN, force, "sinusoidal, noise"},
        {"force_deviation_kN", &drill.source.force.deviation, kN, force, "sinusoidal, noise"},
        {"torque_mean_N_m", &drill.source.torque.mean, 1.0, torque, "sinusoidal, noise"},
        {"torque_deviation_N_m", &drill.source.torque.deviation, 1.0, torque, "sinusoidal, noise"},
        {"waves_per_turn", &drill.source.waves_per_turn, 1.0, waves, "sinusoidal"},
        {"piece_deg", &drill.source.piece_angle, deg, between(0.01, 360.0), "noise: angle of one draw"}}},
      {"run",
       {{"duration_s", &drill.run.duration, 1.0, duration, "simulated time", true},
        {"step_ms", &drill.run.step, ms, step, "of the solver"},
        {"sample_ms", &drill.run.sample, ms, sample, "between rows of the result"},
        {"settling_s", &drill.run.settling, 1.0, pause, "at the beginning, left out of the summary"},
        {"start", &words.start, 1.0, any(), "'turning' or 'rest'"},
        {"off_bottom_mm", &drill.run.off_bottom, mm, lift, "lift of the bit at the beginning"}}},
  };
}

std::vector<base::Section> describe(DrillCase& drill, Words& words) {
  std::vector<base::Section> sections = describe_operation(drill, words);
  for (const auto part : {describe_bit_rock, describe_run}) {
    for (base::Section& section : part(drill, words)) sections.push_back(std::move(section));
  }
  return base::also_in_oilfield_units(
      std::move(sections),
      {"torque_kN_m", "hook_load_kN", "weight_on_bit_kN", "friction_radius_mm", "normal_force_kN", "radius_mm",
       "threshold_weight_kN", "imposed_weight_kN", "pressure_drop_MPa", "nozzle_area_mm2", "density_kg_per_m3",
       "force_mean_kN", "force_deviation_kN", "torque_mean_N_m", "torque_deviation_N_m"});
}

void take_words(const base::ConfigFile& file, const Words& words, DrillCase& drill) {
  drill.drive.imposes_speed = meaning_of(file, "top_drive", "imposes", words.imposes, imposed);
  drill.control.answer = meaning_of(file, "top_drive", "control", words.control, drive_answers);
  drill.hoist.rule = meaning_of(file, "top_drive", "hoist", words.hoist, hoist_rules);
  drill.jets_push_up = meaning_of(file, "fluid", "jet_force", words.jets, directions);
  drill.bit_rock.friction.law = meaning_of(file, "friction", "law", words.friction, friction_laws);
  drill.wall_friction.law = meaning_of(file, "wall", "law", words.wall, friction_laws);
  drill.bit_rock.advance_law = meaning_of(file, "drilling", "law", words.advance, advance_laws);
  drill.bit_rock.unloading = meaning_of(file, "bit_rock", "unloading", words.unloading, unloadings);
  drill.bit_rock.axial_source = meaning_of(file, "bit_rock", "axial_source", words.axial_source, axial_sources);
  drill.source.kind = meaning_of(file, "excitation", "source", words.source, sources);
  drill.run.turning = meaning_of(file, "run", "start", words.start, starts);
}

Words words_of(const DrillCase& drill) {
  return {.lumping = word_of(drill.lumping, lumpings),
          .imposes = word_of(drill.drive.imposes_speed, imposed),
          .jets = word_of(drill.jets_push_up, directions),
          .friction = word_of(drill.bit_rock.friction.law, friction_laws),
          .wall = word_of(drill.wall_friction.law, friction_laws),
          .advance = word_of(drill.bit_rock.advance_law, advance_laws),
          .unloading = word_of(drill.bit_rock.unloading, unloadings),
          .axial_source = word_of(drill.bit_rock.axial_source, axial_sources),
          .source = word_of(drill.source.kind, sources),
          .start = word_of(drill.run.turning, starts),
          .control = word_of(drill.control.answer, drive_answers),
          .hoist = word_of(drill.hoist.rule, hoist_rules)};
}

void read_pipes(base::ConfigFile& file, DrillCase& drill) {
  Words words;
  file.fill(describe_string(drill, words));
  drill.lumping = meaning_of(file, "string", "lumping", words.lumping, lumpings);
  for (int i = 0; i < file.count("pipe"); ++i) drill.pipes.push_back(read_pipe(file, i));
}

/// The chains as the file gives them; the axial one has no spring above its first mass.
void read_chains(base::ConfigFile& file, DrillCase& drill) {
  file.fill(describe_axial(drill.axial));
  file.fill(describe_torsion(drill.torsional));
  const auto check = [&](const char* section, const char* key, const std::vector<double>& values, std::size_t count) {
    if (values.size() != count)
      file.refuse(section, key, fmt::format("has {} entries (must have {})", values.size(), count));
  };
  const std::size_t masses = drill.axial.size(), inertias = drill.torsional.size();
  if (inertias == 0) file.refuse("torsion", "inertia_kg_m2", "is empty (needs at least one inertia, or [[pipe]])");
  check("torsion", "stiffness_N_m_per_rad", drill.torsional.stiffness, inertias);
  check("torsion", "damping_N_m_s_per_rad", drill.torsional.damping, inertias);
  if (masses == 0) return;
  check("axial", "stiffness_N_per_m", drill.axial.stiffness, masses - 1);
  check("axial", "damping_N_s_per_m", drill.axial.damping, masses - 1);
}

void check_together(const base::ConfigFile& file, const DrillCase& drill) {
  const bool axial = !drill.pipes.empty() || drill.axial.size() > 0;
  const BitRock& rock = drill.bit_rock;
  check_top_drive(file, drill, axial);
  if (axial && rock.imposed_weight > 0.0)
    file.refuse("drilling", "imposed_weight_kN",
                "needs a string without axial chain; here hook load and weight give it");
  if (!drill.drive.imposes_speed && drill.drive_inertia == 0.0)
    file.refuse("top_drive", "inertia_kg_m2", "must be above 0 for a drive that imposes torque");
  if (rock.friction.law != FrictionLaw::none && rock.friction_radius == 0.0 && drill.bit.cutters.empty())
    file.refuse("bit", "friction_radius_mm", "must be above 0 where there is friction and no bit file");
  if (rock.friction.stribeck.sliding > rock.friction.stribeck.resting)
    file.refuse("friction", "sliding", "must not exceed the coefficient at rest");
  if (drill.source.kind == SourceKind::bit && drill.bit.cutters.empty())
    file.refuse("bit", "file", "is needed by the source 'bit'");
  const DrillSchedule& run = drill.run;
  if (run.step > run.sample) file.refuse("run", "sample_ms", "must be at least step_ms");
  if (run.sample > run.duration) file.refuse("run", "duration_s", "must be at least sample_ms");
  if (run.duration / run.sample > most_samples)
    file.refuse("run", "sample_ms", fmt::format("gives more than {:.0f} rows; raise it", most_samples));
  if (run.duration / run.step > most_steps)
    file.refuse("run", "step_ms", fmt::format("gives more than {:.0e} steps; raise it", most_steps));
  if (run.settling >= run.duration) file.refuse("run", "settling_s", "must be below duration_s");
  if (!drill.wall_force.empty() &&
      drill.wall_force.size() !=
          (drill.pipes.empty() ? drill.torsional.size() : static_cast<std::size_t>(drill.torsional_lumps)))
    file.refuse("wall", "normal_force_kN", "needs one entry for each torsional lump");
}

}  // namespace

DrillCase read_common_tables(base::ConfigFile& file) {
  DrillCase drill;
  Words words;
  for (const base::Section& section : describe(drill, words)) file.fill(section);
  if (file.count("cutter") > 0) {
    if (!drill.bit_file.empty())
      file.refuse("bit", "file", "[[cutter]] of a bit stand in this file too; give one of the two");
    drill.bit = bit_inside(file);
  }
  take_words(file, words, drill);
  return drill;
}

void complete(base::ConfigFile& file, DrillCase& drill) {
  if (!drill.bit_file.empty()) {
    drill.bit_file = file.resolve(drill.bit_file).string();
    drill.bit = read_bit(drill.bit_file);
  }
  if (!drill.source.model_file.empty()) drill.source.model_file = file.resolve(drill.source.model_file).string();
  check_together(file, drill);
}

namespace {

/// The keys of the file, without looking at the files they name.
DrillCase read_keys(base::ConfigFile& file) {
  if (file.has_table("well"))
    throw base::InputError(file.name() +
                           ": a case with [well] (drill run, modes, statics and broomstick take one, and export fmu)");
  DrillCase drill = read_common_tables(file);
  if (file.count("pipe") > 0) {
    read_pipes(file, drill);
  } else {
    if (file.has("string")) throw base::InputError(file.name() + ": [string] without [[pipe]] (needs at least one)");
    read_chains(file, drill);
  }
  file.refuse_unknown();
  return drill;
}

}  // namespace

DrillCase read_drill_case(base::ConfigFile& file) {
  DrillCase drill = read_keys(file);
  complete(file, drill);
  return drill;
}

DrillCase read_drill_case(const std::filesystem::path& path) {
  base::ConfigFile file = base::ConfigFile::read(path);
  return read_drill_case(file);
}

DrillCase recorded_drill_case(std::string_view text, const std::string& name) {
  base::ConfigFile file = base::ConfigFile::from_text(text, name);
  return read_keys(file);
}

namespace {

/// Puts the bit where its file was named: key by key, so that the text needs no other file.
void put_bit_inside(std::vector<base::Section>& sections, Bit& bit, BitWords& words) {
  std::vector<base::Section> of_bit = describe(bit, words);
  const auto section = std::find_if(sections.begin(), sections.end(), [](const auto& s) { return s.name == "bit"; });
  std::erase_if(section->fields, [](const base::Field& field) { return field.name == "file"; });
  section->fields.insert(section->fields.end(), of_bit.front().fields.begin(), of_bit.front().fields.end());
  sections.insert(sections.end(), of_bit.begin() + 1, of_bit.end());
}

}  // namespace

std::string resolved_common_toml(const DrillCase& drill, std::vector<base::Section> more,
                                 const std::vector<std::string>& left_out) {
  DrillCase copy = drill;
  Words words = words_of(drill);
  std::vector<base::Section> sections = describe(copy, words);
  leave_out_unused_of_top_drive(sections, copy);
  const auto is_out = [&](const std::string& name) {
    return std::find(left_out.begin(), left_out.end(), name) != left_out.end();
  };
  std::erase_if(sections, [&](const base::Section& section) { return is_out(section.name); });
  for (base::Section& section : sections)
    std::erase_if(section.fields, [&](const base::Field& field) { return is_out(section.name + "." + field.name); });
  std::move(more.begin(), more.end(), std::back_inserter(sections));
  BitWords words_of_bit = words_of(copy.bit);
  if (!copy.bit.cutters.empty()) put_bit_inside(sections, copy.bit, words_of_bit);
  for (base::Section& section : sections) {  // a list that is empty was not given
    std::erase_if(section.fields, [](const base::Field& field) {
      const auto* list = std::get_if<std::vector<double>*>(&field.target);
      return list != nullptr && (*list)->empty();
    });
  }
  return base::to_exact_toml(sections);
}

std::string resolved_toml(const DrillCase& drill) {
  DrillCase copy = drill;
  Words words = words_of(drill);
  std::vector<base::Section> string;
  if (copy.pipes.empty()) {
    if (copy.axial.size() > 0) string.push_back(describe_axial(copy.axial));
    string.push_back(describe_torsion(copy.torsional));
  } else {
    string.push_back(describe_string(copy, words));
    for (PipeSection& pipe : copy.pipes) {
      string.push_back(describe(pipe));
      string.back().name = "[pipe]";  // an array of tables
    }
  }
  return resolved_common_toml(drill, std::move(string));
}

std::vector<base::KeyRow> drill_keys() {
  DrillCase drill;
  Words words;
  PipeSection pipe;
  std::string size;
  std::vector<base::Section> sections = describe(drill, words);
  const auto behind_name = sections.begin() + 1;
  std::vector<base::Section> string{describe_string(drill, words), describe_size(size), describe(pipe),
                                    describe_axial(drill.axial), describe_torsion(drill.torsional)};
  string[1].name = string[2].name = "[pipe]";  // an array of tables
  sections.insert(behind_name, string.begin(), string.end());
  return base::key_rows(sections);
}

}  // namespace bitrock::runtime
