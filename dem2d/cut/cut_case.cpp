#include "dem2d/cut/cut_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/unit_hint.hpp"
#include "base/units.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/specimen/grading.hpp"

namespace bitrock::dem2d {

namespace {
using base::deg, base::mm, base::MPa, base::um;

// The cutter must keep this many depths of rock in front of it at the end, so that the side wall does not confine the
// last chips; and this many below it, so that the bottom does not.
constexpr double depths_ahead = 3.0;
constexpr double depths_below = 2.0;

// Lengths that are just allowed stay so when they are written in millimetres and read back.
constexpr double rounding = 1.0 + 1e-12;

// Of moving rock, where not all of it moves: so many depths, and the column of discs (two largest radii) that is held.
// With less the cutter meets rock that is held; forces are right only from more than twice as much on
// (docs/decisions/0009).
constexpr double depths_moving_ahead = 3.0, depths_moving_behind = 1.0, columns_moving = 1.0;

// Under mud, below which there is a warning.
constexpr double depths_ahead_in_mud = 10.0;

constexpr double most_samples = 1e7;  // 80 MB for each recorded quantity
}  // namespace

std::vector<base::Section> describe(CutCase& cut) {
  using base::any, base::between, base::zero_or;
  // Ten times beyond what there is, near enough to catch a slipped unit: cutters have 8 to 25 mm; the longest bed is a
  // block of 10 m.
  const base::Range cutter = between(0.5, 250.0), ground_off = zero_or(1e-3, 50.0), clearance = zero_or(0.1, 60.0);
  const base::Range length = between(0.1, 1e4), from_zero = zero_or(0.01, 1e4);
  const base::Range sampling = between(0.01, 1e4);  // a hundredth of the smallest grain, and less, to some grains
  const base::Range margin = between(0.1, 1e3);     // chips that fly farther meet no rock any more
  const base::Range step_factor = between(1e-3, longest_step_factor);  // smaller ones only cost time
  const base::Range damping{.low = 0.0, .high = 1.0, .high_open = true};
  const base::Range seal_gap = between(0.001, 0.25);  // farther apart than 0.3 discs are not on each other's lists
  return {
      {"",
       {{"rock", &cut.rock_file, 1.0, any(), "rock file, relative to this file; or the tables of a rock here", true}}},
      {"cut",
       {{"cutter_speed_m_per_s", &cut.cutter_speed, 1.0, cutter_speed_m_per_s, "along the surface", true},
        {"depth_of_cut_mm", &cut.depth_of_cut, mm, depth_of_cut_mm, "surface above the tip", true},
        {"back_rake_deg", &cut.back_rake, deg, back_rake_deg, "lean of the face out of the vertical", true},
        {"run_in_mm", &cut.run_in, mm, from_zero, "travel before forces count: the fresh edge of the bed"},
        {"cut_length_mm", &cut.cut_length, mm, length, "travel of the cutter after that"}}},
      {"cutter",
       {{"diameter_mm", &cut.cutter_diameter, mm, cutter, "length of the face"},
        {"thickness_mm", &cut.cutter_thickness, mm, cutter, "behind the face"},
        {"friction_coefficient", &cut.cutter_friction, 1.0, between(0.0, 10.0), "between cutter and rock"},
        base::left_out_at_zero(
            {"clearance_deg", &cut.cutter_clearance, deg, clearance, "rise of the underside; 0: the back rake"}),
        base::left_out_at_zero({"chamfer_mm", &cut.cutter_chamfer, mm, ground_off,
                                "of the edge, up the face, at 45 degrees to it; 0: sharp"}),
        base::left_out_at_zero(
            {"wear_flat_mm", &cut.cutter_wear_flat, mm, ground_off, "length of the flat along the cut; 0: none"})}},
      {"bed",
       {{"length_mm", &cut.bed_length, mm, length, "of the rock, along the cut"},
        {"height_mm", &cut.bed_height, mm, length, "of the rock, from bottom to surface"},
        {"moving_ahead_mm", &cut.moving_ahead, mm, from_zero, "rock ahead of the tip that moves; 0: all of it"},
        {"moving_behind_mm", &cut.moving_behind, mm, from_zero, "rock behind the tip that moves; 0: all of it"}}},
      {"run",
       {{"local_damping", &cut.local_damping, 1.0, damping, "share of the unbalanced force"},
        {"sampling_distance_um", &cut.sampling_distance, um, sampling, "travel between two force samples"},
        {"step_factor", &cut.step_factor, 1.0, step_factor, "share of the longest stable step"},
        {"domain_margin_mm", &cut.domain_margin, mm, margin, "discs farther from the bed are removed"}}},
      {"fluid",
       {{"pressure_MPa", &cut.mud_pressure, MPa, fluid_pressure_MPa, "of the mud above that of the pores; 0: no mud"},
        {"debris", &cut.debris, 1.0, any(), "sealed: touching debris keeps the mud out; drained: only joints do"},
        {"cutter_face", &cut.cutter_face, 1.0, any(), "open: mud comes between cutter and debris; sealed: it does not"},
        {"seal_gap_over_radius", &cut.seal_gap_over_radius, 1.0, seal_gap,
         "widest gap that mud does not enter, over the smallest radius"}}},
  };
}

namespace {

/// What a study sizes by the depth of each case stays in the ranges of a cut file, too.
void check_ranges(const CutCase& cut, const std::string& source) {
  CutCase copy = cut;
  for (const base::Section& section : describe(copy)) {
    for (const base::Field& field : section.fields) {
      const auto* number = std::get_if<double*>(&field.target);
      if (number == nullptr || field.range.contains(**number / field.si_per_unit)) continue;
      const double value = base::in_units(**number, field.si_per_unit);
      if (field.range.contains(value)) continue;
      throw base::InputError(fmt::format("{}: {}.{} = {:.6g} ({})", source, section.name, field.name, value,
                                         base::out_of_range(field.name, value, field.range)));
    }
  }
}

}  // namespace

void check_cut_case(const CutCase& cut, const std::string& source) {
  const auto refuse = [&source](const std::string& what) { throw base::InputError(source + ": " + what); };
  check_ranges(cut, source);
  if (cut.depth_of_cut * (1.0 + depths_below) > cut.bed_height * rounding) {
    refuse(fmt::format(
        "cut.depth_of_cut_mm = {:.4g} (at most a third of bed.height_mm = {:.4g}: the bottom must not carry the chip)",
        cut.depth_of_cut / mm, cut.bed_height / mm));
  }
  if (cut.run_in + cut.cut_length + depths_ahead * cut.depth_of_cut > cut.bed_length * rounding) {
    refuse(
        fmt::format("cut.cut_length_mm = {:.4g} (with {:.4g} mm of depth at most {:.4g}: bed.length_mm = {:.4g} less "
                    "three depths and "
                    "cut.run_in_mm)",
                    cut.cut_length / mm, cut.depth_of_cut / mm,
                    (cut.bed_length - depths_ahead * cut.depth_of_cut - cut.run_in) / mm, cut.bed_length / mm));
  }
  if (cut.depth_of_cut > cut.cutter_diameter * std::cos(cut.back_rake)) {
    refuse(fmt::format("cut.depth_of_cut_mm = {:.4g} (at most {:.4g}, the height of the cutter's face)",
                       cut.depth_of_cut / mm, cut.cutter_diameter * std::cos(cut.back_rake) / mm));
  }
  const CutterShape shape = cutter_shape(cut);
  if (cut.cutter_chamfer >= 0.5 * std::min(cut.cutter_diameter, cut.cutter_thickness)) {
    refuse(
        fmt::format("cutter.chamfer_mm = {:.4g} (must be below half of cutter.diameter_mm and of cutter.thickness_mm)",
                    cut.cutter_chamfer / mm));
  }
  if (cut.cutter_wear_flat > 0.0 && cut.cutter_wear_flat >= longest_wear_flat(shape)) {
    refuse(
        fmt::format("cutter.wear_flat_mm = {:.4g} (must be below {:.4g}: there the flat reaches the back of the "
                    "cutter{})",
                    cut.cutter_wear_flat / mm, longest_wear_flat(shape) / mm,
                    shape.clearance == 0.0 && shape.back_rake == 0.0 ? "; give cutter.clearance_deg" : ""));
  }
  if (cut.sampling_distance * 3.0 > cut.cut_length) {
    refuse(fmt::format("run.sampling_distance_um = {:.4g} (at most a third of the cut: {:.4g})",
                       cut.sampling_distance / um, cut.cut_length / 3.0 / um));
  }
  const double column = 2.0 * largest_radius(cut.rock, cut.bed_height);
  const auto check_moving = [&](const char* key, double length, double depths) {
    const double least = depths * cut.depth_of_cut + columns_moving * column;
    if (length == 0.0 || length * rounding >= least) return;
    refuse(
        fmt::format("bed.{} = {:.4g} (0 for all of the rock, or at least {:.4g}: {:g} depths and {:g} largest grains)",
                    key, length / mm, least / mm, depths, columns_moving));
  };
  check_moving("moving_ahead_mm", cut.moving_ahead, depths_moving_ahead);
  check_moving("moving_behind_mm", cut.moving_behind, depths_moving_behind);
  if ((cut.moving_ahead > 0.0 || cut.moving_behind > 0.0) && cut.sampling_distance > column) {
    refuse(
        fmt::format("run.sampling_distance_um = {:.4g} (at most {:.4g}, the largest grain, where only a part of the "
                    "bed moves: that part moves on between samples)",
                    cut.sampling_distance / um, column / um));
  }
  const double softest = std::min(cut.rock.joint_stiffness_ratio, cut.rock.contact_stiffness_ratio);
  if (cut.step_factor > usual_step_factor && softest < 1.0) {
    refuse(
        fmt::format("run.step_factor = {:.4g} (at most {:g} with a stiffness_ratio below 1, here {:.4g}: the bound "
                    "of the stable step needs normals at least as stiff as shear)",
                    cut.step_factor, usual_step_factor, softest));
  }
  const auto check_word = [&](const char* key, const std::string& word, const char* one, const char* other) {
    if (word != one && word != other)
      refuse(fmt::format("fluid.{} = \"{}\" (must be \"{}\" or \"{}\")", key, word, one, other));
  };
  check_word("debris", cut.debris, debris_sealed, debris_drained);
  check_word("cutter_face", cut.cutter_face, face_open, face_sealed);
  check_specimen_size(cut.rock, cut.bed_length, cut.bed_height, source + ": [bed]");
  const double travel = cut.run_in + cut.cut_length;
  if (travel / cut.sampling_distance > most_samples) {
    refuse(
        fmt::format("run.sampling_distance_um = {:.4g} (a cut of {:.4g} mm would have {:.3g} samples, at most {:.0e})",
                    cut.sampling_distance / um, travel / mm, travel / cut.sampling_distance, most_samples));
  }
}

std::vector<std::string> warnings(const CutCase& cut) {
  std::vector<std::string> found;
  const double mean_diameter = dem2d::mean_diameter(cut.rock);
  if (cut.depth_of_cut < mean_diameter) {
    found.push_back(fmt::format(
        "cut.depth_of_cut_mm = {:.4g} is {:.2g} of a grain (mean diameter {:.4g} mm): the cutter ploughs through "
        "single grains; take a rock of finer grains",
        cut.depth_of_cut / mm, cut.depth_of_cut / mean_diameter, mean_diameter / mm));
  }
  const auto look_at = [&](const char* key, double length) {
    if (length >= mean_diameter) return;
    found.push_back(
        fmt::format("cutter.{} = {:.4g} is {:.2g} of a grain (mean diameter {:.4g} mm): the cutter is a needle among "
                    "grains; is one "
                    "of the two in another unit?",
                    key, length / mm, length / mean_diameter, mean_diameter / mm));
  };
  if (cut.mud_pressure > 0.0 && cut.moving_ahead > 0.0 && cut.moving_ahead < depths_ahead_in_mud * cut.depth_of_cut) {
    found.push_back(
        fmt::format("bed.moving_ahead_mm = {:.4g} is {:.3g} depths of cut; under mud the thrust reaches farther (12 "
                    "and more are safe)",
                    cut.moving_ahead / mm, cut.moving_ahead / cut.depth_of_cut));
  }
  look_at("diameter_mm", cut.cutter_diameter);
  look_at("thickness_mm", cut.cutter_thickness);
  return found;
}

namespace {

std::vector<base::Section> case_and_rock(CutCase& cut) {
  std::vector<base::Section> sections = describe(cut);
  sections.erase(sections.begin());  // the rock's content says it better than its file name
  leave_out_unused(sections, cut);
  // a cut brings its own bed
  for (base::Section& section : describe_material(cut.rock)) sections.push_back(std::move(section));
  return sections;
}

CutCase checked(base::ConfigFile file) {
  CutCase cut;
  const bool inside = has_rock_inside(file);
  if (inside) cut.rock = rock_inside(file);
  std::vector<base::Section> sections = describe(cut);
  if (inside) sections.erase(sections.begin());
  for (const base::Section& section : sections) file.fill(section);
  file.refuse_unknown();
  if (!inside) cut.rock = read_rock(file.resolve(cut.rock_file));
  check_cut_case(cut, file.name());
  return cut;
}

}  // namespace

CutterShape cutter_shape(const CutCase& cut) {
  return {.diameter = cut.cutter_diameter,
          .thickness = cut.cutter_thickness,
          .back_rake = cut.back_rake,
          .clearance = cut.cutter_clearance,
          .chamfer = cut.cutter_chamfer,
          .wear_flat = cut.cutter_wear_flat};
}

void leave_out_unused(std::vector<base::Section>& sections, const CutCase& cut) {
  if (cut.mud_pressure == 0.0) std::erase_if(sections, [](const base::Section& s) { return s.name == "fluid"; });
}

CutCase read_cut_case(const std::filesystem::path& path) {
  return checked(base::ConfigFile::read(path));
}

std::string resolved_toml(const CutCase& cut) {
  CutCase copy = cut;
  return base::to_toml(case_and_rock(copy));
}

std::string exact_toml(const CutCase& cut) {
  CutCase copy = cut;
  return base::to_exact_toml(case_and_rock(copy));
}

CutCase parse_resolved(const std::string& text, const std::string& name) {
  return checked(base::ConfigFile::from_text(text, name));
}

}  // namespace bitrock::dem2d
