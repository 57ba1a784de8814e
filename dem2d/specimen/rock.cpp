#include "dem2d/specimen/rock.hpp"

#include <algorithm>

#include "base/units.hpp"
#include "dem2d/contact/flat_joint.hpp"

namespace bitrock::dem2d {

namespace {

using base::deg, base::GPa, base::mm, base::MPa;

/// Checks that concern several keys.
void check(const base::ConfigFile& file, const Rock& rock) {
  if (rock.radius_max < rock.radius_min) {
    file.refuse("discs", "radius_max_mm", "must be at least discs.radius_min_mm");
  }
  if (rock.installation_gap > rock.radius_min) {
    file.refuse("flat_joints", "installation_gap_mm",
                "must be at most discs.radius_min_mm: only neighbours are joined");
  }
  if (rock.tensile_strength_deviation > 0.5 * rock.tensile_strength) {
    file.refuse("flat_joints", "tensile_strength_deviation_MPa", "must be at most half of tensile_strength_MPa");
  }
  if (rock.cohesion_deviation > 0.5 * rock.cohesion) {
    file.refuse("flat_joints", "cohesion_deviation_MPa", "must be at most half of cohesion_MPa");
  }
  if (rock.gapped_fraction + rock.slit_fraction > 1.0) {
    file.refuse("flat_joints", "slit_fraction", "with gapped_fraction must be at most 1");
  }
  if (rock.initial_gap > rock.radius_min) {
    file.refuse("flat_joints", "initial_gap_mm", "must be at most discs.radius_min_mm");
  }
  if (rock.gapped_fraction > 0.0 && !(rock.initial_gap > 0.0)) {
    file.refuse("flat_joints", "gapped_fraction",
                "needs initial_gap_mm > 0 (touching unbonded joints are slit_fraction)");
  }
  if (rock.packing_pressure > 0.1 * rock.packing_modulus) {
    file.refuse("packing", "pressure_MPa",
                "must be at most a tenth of packing.effective_modulus_GPa, or discs overlap by a tenth");
  }
}

Rock checked(base::ConfigFile file) {
  Rock rock;
  for (const base::Section& section : describe(rock)) file.fill(section);
  file.refuse_unknown();
  check(file, rock);
  return rock;
}

}  // namespace

std::vector<base::Section> describe(Rock& rock) {
  using base::between, base::any;
  const base::Range below_90{.low = 0.0, .high = 90.0, .high_open = true};
  // Ten times beyond what there is, near enough to catch a slipped unit. Grains: from clay to boulders. Densities: from
  // light pumice to ten times quartz. Moduli [GPa]: from soft soil to diamond. Strengths [MPa]: from a soil of 1 kPa to
  // ten times what joints of the strongest rock need.
  const base::Range radius = between(1e-3, 100.0), density = between(100.0, 3e4);
  const base::Range modulus = between(1e-3, 1e3), strength = between(1e-3, 1e4), to_strength = between(0.0, 1e4);
  const base::Range stable_ratio = between(0.3, 1e3);  // softer normals outrun the critical step (step/step.hpp)
  return {
      {"rock", {{"name", &rock.name, 1.0, any(), "what this rock is called in reports"}}},
      {"discs",
       {{"radius_min_mm", &rock.radius_min, mm, radius, "smallest disc radius", true},
        {"radius_max_mm", &rock.radius_max, mm, radius, "largest disc radius", true},
        {"density_kg_per_m3", &rock.density, 1.0, density, "density of a grain"},
        {"porosity", &rock.porosity, 1.0, between(0.05, 0.3), "of the cloud before packing, overlaps not counted"}}},
      {"grading",
       {{"fine_depth_mm", &rock.fine_depth, mm, base::zero_or(0.01, 1e4),
         "from the surface; larger discs below; 0: nowhere"},
        {"coarse_ratio", &rock.coarse_ratio, 1.0, between(1.0, 4.0), "radii of the larger discs over the others"}}},
      {"flat_joints",
       {{"effective_modulus_GPa", &rock.joint_modulus, GPa, modulus, "E* of the joints", true},
        {"stiffness_ratio", &rock.joint_stiffness_ratio, 1.0, stable_ratio, "normal over shear stiffness", true},
        {"tensile_strength_MPa", &rock.tensile_strength, MPa, strength, "of an element", true},
        {"cohesion_MPa", &rock.cohesion, MPa, strength, "of an element", true},
        {"friction_angle_deg", &rock.friction_angle, deg, below_90, "of a bonded element"},
        {"friction_coefficient", &rock.friction, 1.0, between(0.0, 10.0), "of a broken element"},
        {"elements", &rock.elements, 1.0, between(1, max_elements), "elements of a joint"},
        {"radius_multiplier", &rock.radius_multiplier, 1.0, between(0.01, 1.0), "half-length over smaller radius"},
        {"installation_gap_mm", &rock.installation_gap, mm, between(0.0, 100.0), "discs closer than this are joined"},
        {"tensile_strength_deviation_MPa", &rock.tensile_strength_deviation, MPa, to_strength, "standard deviation"},
        {"cohesion_deviation_MPa", &rock.cohesion_deviation, MPa, to_strength, "standard deviation"},
        {"gapped_fraction", &rock.gapped_fraction, 1.0, between(0.0, 1.0), "of joints not bonded, apart at the start"},
        {"slit_fraction", &rock.slit_fraction, 1.0, between(0.0, 1.0), "of joints not bonded, touching at the start"},
        {"initial_gap_mm", &rock.initial_gap, mm, between(0.0, 100.0), "of gapped joints"},
        {"residual_cohesion_MPa", &rock.residual_cohesion, MPa, to_strength, "of elements broken in shear"},
        {"drop_to_residual", &rock.drop_to_residual, 1.0, any(), "shear stress at a shear break: false to zero"},
        base::left_out_at_zero({"tension_softening", &rock.tension_softening, 1.0, base::zero_or(0.01, 100.0),
                                "opening from full tensile strength to none, over that up to it; 0: breaks at once"})}},
      {"linear_contacts",
       {{"effective_modulus_GPa", &rock.contact_modulus, GPa, modulus, "E* between loose discs, cutter and walls"},
        {"stiffness_ratio", &rock.contact_stiffness_ratio, 1.0, stable_ratio, "normal over shear stiffness"},
        {"friction_coefficient", &rock.contact_friction, 1.0, between(0.0, 10.0), "between loose discs"},
        {"damping_ratio", &rock.contact_damping_ratio, 1.0, between(0.0, 1.0), "normal dashpot, share of critical"},
        {"shear_damping_ratio", &rock.contact_shear_damping_ratio, 1.0, between(0.0, 1.0),
         "shear dashpot, share of critical"}}},
      {"packing",
       {{"effective_modulus_GPa", &rock.packing_modulus, GPa, modulus, "E* while packing"},
        {"local_damping", &rock.packing_damping, 1.0, between(0.05, 0.95), "while packing"},
        {"pressure_MPa", &rock.packing_pressure, MPa, to_strength, "isotropic, by growing all discs; 0: no target"},
        {"equilibrium_ratio", &rock.equilibrium_ratio, 1.0, between(1e-8, 0.1), "unbalanced over contact force"}}},
      {"specimen",
       {{"width_mm", &rock.specimen_width, mm, specimen_length_mm, "of a specimen made on its own"},
        {"height_mm", &rock.specimen_height, mm, specimen_length_mm, "of a specimen made on its own"}}},
  };
}

std::vector<base::Section> describe_material(Rock& rock) {
  std::vector<base::Section> sections = describe(rock);
  std::erase_if(sections, [](const base::Section& section) { return section.name == "specimen"; });
  return sections;
}

Rock read_rock(const std::filesystem::path& path) {
  return checked(base::ConfigFile::read(path));
}

bool has_rock_inside(const base::ConfigFile& file) {
  Rock rock;
  const std::vector<base::Section> tables = describe_material(rock);
  return std::any_of(tables.begin(), tables.end(), [&](const auto& table) { return file.has_table(table.name); });
}

Rock rock_inside(base::ConfigFile& file) {
  if (file.has("rock") && !file.has_table("rock"))
    file.refuse("", "rock", "the tables of a rock stand in this file too; give one of the two");
  Rock rock;
  for (const base::Section& section : describe_material(rock)) file.fill(section);
  check(file, rock);
  return rock;
}

Rock parse_rock(std::string_view text, const std::string& name) {
  return checked(base::ConfigFile::from_text(text, name));
}

}  // namespace bitrock::dem2d
