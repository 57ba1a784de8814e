// One cut: made here or read from a run file; its forces, cracks, energies and discs.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <limits>
#include <map>
#include <optional>

#include "base/errors.hpp"
#include "dem2d/files/frame_file.hpp"
#include "dem2d/files/run_file.hpp"
#include "peaks/statistics.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/computing.hpp"
#include "python/cracks.hpp"
#include "python/input.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using dem2d::CutCase, dem2d::CutRun, dem2d::Energies, dem2d::Frame;

struct Run {
  CutCase cut;
  CutRun run;
  std::uint64_t seed = 0;
  std::map<std::string, std::vector<double>> energy;  ///< empty: not measured
  std::string file;                                   ///< it was read from; empty: made here
};

std::string array_name(const dem2d::EnergyEntry& entry) {
  return fmt::format("{}_J_per_m", entry.name);
}

std::map<std::string, std::vector<double>> energies_of(const CutRun& run) {
  std::map<std::string, std::vector<double>> energy;
  if (run.energies.empty()) return energy;
  for (const dem2d::EnergyEntry& entry : dem2d::energy_entries) {
    if (entry.only_under_mud && run.settled.steps == 0) continue;
    for (const Energies& instant : run.energies) energy[array_name(entry)].push_back(instant.*entry.value);
  }
  return energy;
}

std::map<std::string, std::vector<double>> energies_of(const base::Hdf5Reader& file) {
  std::map<std::string, std::vector<double>> energy;
  if (!file.has("/energy")) return energy;
  for (const dem2d::EnergyEntry& entry : dem2d::energy_entries) {
    const std::string path = "/energy/" + array_name(entry);
    if (!entry.only_under_mud || file.has(path)) energy[array_name(entry)] = file.doubles(path);
  }
  return energy;
}

/// What the mud did before the cut, and to its window.
py::object under_mud(const Run& run) {
  const dem2d::Settled& settled = run.run.settled;
  if (settled.steps == 0) return py::none();
  py::dict dict;
  dict["surface_drop_m"] = settled.surface_drop;
  dict["shortening_m"] = settled.shortening;
  dict["broken_elements"] = settled.cracks;
  dict["settling_steps"] = settled.steps;
  dict["forced_entries"] = run.run.forced_entries;
  return dict;
}

Run read_run(const py::object& path, bool frames) {
  const base::Hdf5Reader file(input_path(path));
  dem2d::RunFile whole = dem2d::read_run(file);
  Run run{.cut = std::move(whole.cut), .run = std::move(whole.run), .seed = whole.seed, .file = file.name()};
  run.energy = energies_of(file);
  constexpr long long most_discs = std::numeric_limits<int>::max();
  run.run.removed_discs = static_cast<int>(file.integer_attribute("removed_discs", 0, most_discs));
  if (!frames) return run;
  run.run.frames.clear();
  for (int k = 0; k < whole.frame_count; ++k) run.run.frames.push_back(dem2d::read_frame(file, k));
  return run;
}

void save(const Run& run, const py::object& path) {
  if (!run.file.empty())
    throw base::InputError(fmt::format("this run was read from {} (copy that file instead)", run.file));
  dem2d::write_run(run.run, run.cut, run.seed, output_path(path));
}

/// The fields that a case file must have.
void require_all(const std::vector<base::Section>& sections, const py::dict& keywords) {
  for (const base::Section& section : sections) {
    for (const base::Field& field : section.fields) {
      if (!field.required || section.name.empty() || keywords.contains(field.name.c_str())) continue;
      throw base::InputError(
          fmt::format("{} is missing ({}); give a case file or this keyword", field.name, field.meaning));
    }
  }
}

CutCase case_of(const py::object& source, const py::object& rock, const py::dict& keywords) {
  CutCase cut;
  if (source.is_none()) {
    if (rock.is_none()) throw base::InputError("neither a case nor a rock (give a case file, or rock=...)");
  } else {
    cut = read_input(source, "case", dem2d::read_cut_case, dem2d::parse_resolved);
  }
  if (!rock.is_none()) cut.rock = read_input(rock, "rock", dem2d::read_rock, dem2d::parse_rock);
  const std::vector<base::Section> sections = dem2d::describe(cut);
  if (source.is_none()) require_all(sections, keywords);
  set_by_keyword({sections.begin() + 1, sections.end()}, keywords);  // without the name of the rock's file
  dem2d::check_cut_case(cut, "cut");
  return cut;
}

/// The bed of the case; empty: to be made.
std::optional<dem2d::Specimen> given_bed(const py::object& specimen, const CutCase& cut, std::uint64_t seed) {
  if (specimen.is_none()) return std::nullopt;
  auto bed = specimen.cast<dem2d::Specimen>();
  const std::string why = dem2d::mismatch(bed, cut.rock, cut.bed_length, cut.bed_height, seed);
  if (!why.empty()) throw base::InputError("specimen: " + why);
  bed.seed = seed;  // of discs packed elsewhere: what is random in the joints
  return bed;
}

Run cut(const py::object& source, int seed, const py::object& rock, const py::object& specimen, int threads, int frames,
        bool energy, const py::object& progress, const py::kwargs& keywords) {
  require_within("seed", seed, base::between(0, 2147483647));
  require_within("threads", threads, base::between(1, 256));
  require_within("frames", frames, base::between(0, 10000));
  Run result{.cut = case_of(source, rock, keywords), .seed = static_cast<std::uint64_t>(seed)};
  const CutCase& asked = result.cut;
  dem2d::check_frames(frames, dem2d::expected_discs(asked.rock, asked.bed_length, asked.bed_height));
  warn(dem2d::warnings(asked));
  std::optional<dem2d::Specimen> bed = given_bed(specimen, asked, result.seed);
  if (!bed) {
    bed = computed(progress, {"packing the rock", ""}, [&](const base::ProgressCallback& listener) {
      return dem2d::make_specimen(asked.rock, asked.bed_length, asked.bed_height, result.seed, threads, listener);
    });
  }
  warn(dem2d::warnings(*bed));
  result.run = computed(progress, {"cutting", "ms", 1e3}, [&](const base::ProgressCallback& listener) {
    return dem2d::run_cut(asked, *bed, {.threads = threads, .frames = frames, .measure_energy = energy}, listener);
  });
  result.energy = energies_of(result.run);
  return result;
}

void bind_frame(py::module_& module) {
  const auto numbers = [](auto member) {
    return [member](const py::object& self) { return view(self.cast<const Frame&>().*member, self); };
  };
  py::class_<Frame>(module, "Frame", "All discs at one instant.")
      .def_readonly("time_s", &Frame::time, "[s]")
      .def_readonly("tip_x_m", &Frame::tip_x, "place of the cutter's tip along the cut [m]")
      .def_property_readonly("x_m", numbers(&Frame::x), "centres [m], shape (discs,)")
      .def_property_readonly("y_m", numbers(&Frame::y), "centres [m], shape (discs,)")
      .def_property_readonly("radius_m", numbers(&Frame::radius), "[m], shape (discs,)")
      .def_property_readonly("id", numbers(&Frame::id), "shape (discs,)")
      .def_property_readonly("fragment", numbers(&Frame::fragment),
                             "discs of one number hang together; 0 is the bed, shape (discs,)")
      .def_property_readonly("velocity_x_m_per_s", numbers(&Frame::velocity_x),
                             "[m/s], half a step before time_s; empty unless frames were asked for")
      .def_property_readonly("velocity_y_m_per_s", numbers(&Frame::velocity_y), "[m/s], as the other")
      .def_property_readonly("joint_disc_1", numbers(&Frame::joint_disc1),
                             "ids of the discs that bonded joints hold together; empty unless frames were asked for")
      .def_property_readonly("joint_disc_2", numbers(&Frame::joint_disc2), "as the other");
}

}  // namespace

void bind_cut(py::module_& module) {
  bind_frame(module);
  const auto numbers = [](auto member) {
    return [member](const py::object& self) { return view(self.cast<const Run&>().run.*member, self); };
  };
  const auto value = [](auto member) { return [member](const Run& self) { return self.run.*member; }; };
  py::class_<Run>(
      module, "Run",
      "A finished cut. Names and units are those of the run file (docs/reference/formats.md). Forces are of\n"
      "the rock on the cutter, per metre of thickness; resistance (x) and push out of the rock (y) are\n"
      "positive. Arrays are read-only views of what the run holds.")
      .def_property_readonly("time_s", numbers(&CutRun::time), "end of each sampling interval [s], shape (samples,)")
      .def_property_readonly("force_x_N_per_m", numbers(&CutRun::force_x),
                             "mean over each interval [N/m], shape (samples,)")
      .def_property_readonly("force_y_N_per_m", numbers(&CutRun::force_y),
                             "mean over each interval [N/m], shape (samples,)")
      .def_property_readonly(
          "features",
          [](const Run& self) {
            py::dict both;
            both["x"] = peaks::peak_statistics(self.run.force_x);
            both["y"] = peaks::peak_statistics(self.run.force_y);
            return both;
          },
          "peak statistics of both forces: {'x': PeakStatistics, 'y': PeakStatistics}, heights in N/m")
      .def_property_readonly(
          "cracks", [](const Run& self) { return cracks_array(self.run.cracks); },
          "structured array, one row an element that broke: time_s, x_m, y_m, normal_angle_rad, length_m, mode (1\n"
          "tension, 2 shear), disc_1, disc_2")
      .def_property_readonly(
          "energy",
          [](const py::object& self) {
            py::dict energy;
            for (const auto& [name, values] : self.cast<const Run&>().energy) energy[name.c_str()] = view(values, self);
            return energy;
          },
          "energies [J/m] by name, each of shape (samples,): cutter_work_J_per_m, kinetic_J_per_m, ...; empty when "
          "not\n"
          "measured")
      .def_property_readonly(
          "frames",
          [](const py::object& self) {
            py::list frames;
            for (const Frame& frame : self.cast<const Run&>().run.frames)
              frames.append(py::cast(&frame, py::return_value_policy::reference_internal, self));
            return frames;
          },
          "list of Frame, the last of them the end of the cut")
      .def_property_readonly(
          "seed", [](const Run& self) { return self.seed; }, "of the rock")
      .def_property_readonly("discs", value(&CutRun::discs), "at the start")
      .def_property_readonly("joints", value(&CutRun::joints), "at the start")
      .def_property_readonly("step_s", value(&CutRun::step), "[s]")
      .def_property_readonly("steps", value(&CutRun::steps), "of time")
      .def_property_readonly("cut_length_m", value(&CutRun::cut_length), "after the run-in [m]")
      .def_property_readonly("duration_s", value(&CutRun::duration), "after the run-in [s]")
      .def_property_readonly("mean_force_x_N_per_m", value(&CutRun::mean_force_x), "[N/m]")
      .def_property_readonly("mean_force_y_N_per_m", value(&CutRun::mean_force_y), "[N/m]")
      .def_property_readonly("specific_energy_Pa", value(&CutRun::specific_energy), "mean force x over depth [Pa]")
      .def_property_readonly("cracks_tensile", value(&CutRun::cracks_tensile), "elements broken in tension")
      .def_property_readonly("cracks_shear", value(&CutRun::cracks_shear), "elements broken in shear")
      .def_property_readonly("removed_discs", value(&CutRun::removed_discs), "that flew away")
      .def_property_readonly(
          "energy_residual_fraction",
          [](const Run& self) {
            return self.energy.empty() ? std::nullopt : std::optional(self.run.energy_residual_fraction);
          },
          "what the energies do not account for, over the work of the cutter; None when not measured")
      .def_property_readonly("under_mud", &under_mud,
                             "dict: what the mud did to the bed before the cut, and to its window; None without mud")
      .def_property_readonly(
          "energy_injected_fraction",
          [](const Run& self) {
            return self.energy.empty() ? std::nullopt : std::optional(self.run.energy_injected_fraction);
          },
          "what the scheme gave to the rock, over the work of the cutter; None when not measured")
      .def_property_readonly("bed_origin", value(&CutRun::bed_origin), "how the discs were packed")
      .def_property_readonly("wall_s", value(&CutRun::wall_time), "[s] on the clock")
      .def_property_readonly("core_s", value(&CutRun::core_time), "[s] on one core")
      .def_property_readonly("ns_per_disc_step", value(&CutRun::nanoseconds_per_disc_step), "[ns]")
      .def_property_readonly(
          "config_toml", [](const Run& self) { return dem2d::exact_toml(self.cut); },
          "case and rock as a file of which the cut can be made again")
      .def_property_readonly(
          "config_hash", [](const Run& self) { return dem2d::cut_hash(self.cut, self.seed); },
          "fingerprint of case, rock, seed and engine")
      .def("save", &save, py::arg("path"), "Write the run file (.h5), as the program does.")
      .def("__repr__", [](const Run& self) {
        return fmt::format("<bitrock.Run: {} samples, seed {}, mean force x {:.4g} N/m, y {:.4g} N/m>",
                           self.run.time.size(), self.seed, self.run.mean_force_x, self.run.mean_force_y);
      });
  module.def("read_run", &read_run, py::arg("path"), py::kw_only(), py::arg("frames") = false,
             "Read a run file (.h5). frames: also the frames before the last one.");
  module.def("cut", &cut, py::arg("case") = py::none(), py::kw_only(), py::arg("seed") = 1,
             py::arg("rock") = py::none(), py::arg("specimen") = py::none(), py::arg("threads") = 1,
             py::arg("frames") = 0, py::arg("energy") = true, py::arg("progress") = py::none(),
             "Cut synthetic rock with one cutter (Run). Another seed, another rock.\n\n"
             "case: a cut file (str or path), or a dict with its tables. Keywords change its keys: those of [cut] by "
             "their name\n"
             "(depth_of_cut_mm=3), others with their table before it (bed_length_mm, cutter_diameter_mm,\n"
             "run_sampling_distance_um). Without a case, rock and cutter_speed_m_per_s, depth_of_cut_mm, back_rake_deg "
             "must be\n"
             "given.\n"
             "rock: a rock file, or a dict with its tables, in place of that of the case.\n"
             "specimen: a Specimen of that rock and the size of the bed; otherwise it is packed.\n"
             "frames: store all discs at so many instants. energy: measure where the energy goes (a sixth slower).\n"
             "progress: True for a line on sys.stderr, or a function of (done, total), in seconds of the cut.\n"
             "The same case and seed give the same bits for any number of threads, and those of the program.");
}

}  // namespace bitrock::python
