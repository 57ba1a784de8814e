#include "runtime/drillstring/pipe_entry.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/pipe_sizes.hpp"

namespace bitrock::runtime {

using base::between, base::GPa, base::mm, base::zero_or;

namespace {

std::string names() {
  std::string all;
  for (const PipeSize& size : pipe_sizes()) all += fmt::format("{}'{}'", all.empty() ? "" : ", ", size.name);
  return all;
}

}  // namespace

base::Section describe(PipeSection& pipe) {
  // The deepest wells have 15 km. Plastic pipe to sintered carbide; light alloy to tungsten; no pipe has 10 t/m.
  const base::Range length = between(1e-3, 2e4), youngs = between(0.1, 2000.0), shear = between(0.03, 1000.0);
  const base::Range density = between(500.0, 3e4), linear_mass = zero_or(0.01, 1e4);
  const base::Range diameter = between(1.0, 2000.0);  // mm: from a wire to a riser
  const base::Range bore = zero_or(0.5, 2000.0);
  base::Section section{
      "pipe",
      {{"length_m", &pipe.length, 1.0, length, "of the section", true},
       {"outer_diameter_mm", &pipe.outer_diameter, mm, diameter, "of the pipe body", true},
       {"inner_diameter_mm", &pipe.inner_diameter, mm, bore, "of the pipe body", true},
       {"youngs_modulus_GPa", &pipe.youngs_modulus, GPa, youngs, "of the steel"},
       {"shear_modulus_GPa", &pipe.shear_modulus, GPa, shear, "of the steel"},
       {"density_kg_per_m3", &pipe.density, 1.0, density, "of the steel"},
       {"linear_mass_kg_per_m", &pipe.linear_mass, 1.0, linear_mass, "with tool joints; 0: of the body"}}};
  return base::also_in_oilfield_units({section},
                                      {"length_m", "outer_diameter_mm", "inner_diameter_mm", "linear_mass_kg_per_m"})
      .front();
}

base::Section describe_size(std::string& size) {
  return {"pipe", {{"size", &size, 1.0, base::any(), "diameters and linear mass by name: " + names()}}};
}

namespace {

/// Takes what the name says, so that the keys of the entry need not.
void take_size(const base::ConfigFile& file, int i, const std::string& size, PipeSection& pipe,
               base::Section& section) {
  const PipeSize* known = find_pipe_size(size);
  if (known == nullptr) {
    throw base::InputError(
        fmt::format("{}: pipe {}: size = '{}' (must be one of {})", file.name(), i + 1, size, names()));
  }
  pipe.outer_diameter = known->outer_diameter;
  pipe.inner_diameter = known->inner_diameter;
  pipe.linear_mass = known->linear_mass;
  for (base::Field& field : section.fields) field.required = field.required && field.name == "length_m";
}

void require_good(const base::ConfigFile& file, int i, const std::string& size, const PipeSection& pipe) {
  if (pipe.inner_diameter >= pipe.outer_diameter) {
    throw base::InputError(fmt::format("{}: pipe {}: inner diameter {:.6g} mm (must be below the outer one, {:.6g} mm)",
                                       file.name(), i + 1, pipe.inner_diameter / mm, pipe.outer_diameter / mm));
  }
  const PipeSize* known = find_pipe_size(size);
  constexpr double rounding = 0.01 * mm;  // of diameters that are written in millimetres
  if (known == nullptr || (std::abs(pipe.outer_diameter - known->outer_diameter) <= rounding &&
                           std::abs(pipe.inner_diameter - known->inner_diameter) <= rounding))
    return;
  throw base::InputError(
      fmt::format("{}: pipe {}: size = '{}' means {:.6g} and {:.6g} mm, but its keys say {:.6g} and {:.6g} mm (give "
                  "one of the two)",
                  file.name(), i + 1, size, known->outer_diameter / mm, known->inner_diameter / mm,
                  pipe.outer_diameter / mm, pipe.inner_diameter / mm));
}

}  // namespace

PipeSection read_pipe(base::ConfigFile& file, int i) {
  PipeSection pipe;
  std::string size;
  file.fill_entry(describe_size(size), i);
  base::Section section = describe(pipe);
  if (!size.empty()) take_size(file, i, size, pipe, section);
  file.fill_entry(section, i);
  require_good(file, i, size, pipe);
  return pipe;
}

}  // namespace bitrock::runtime
