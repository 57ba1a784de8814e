#pragma once
/// The micro-parameters of a synthetic rock: what a `rock.toml` says. Plain data, SI inside.
///
/// The shipped values and their origin are in campaigns/rocks/article.toml. Stiffness is given as an effective modulus
/// E* and a ratio kappa = kn / ks [ItascaPFC]: a flat joint between discs of radius R1 and R2 gets
/// kn = E* / (R1 + R2), ks = kn / kappa [Pa/m], and half-length R = lambda min(R1, R2).

#include <filesystem>
#include <string>
#include <vector>

#include "base/config.hpp"

namespace bitrock::dem2d {

struct Rock {
  std::string name = "unnamed rock";  ///< for people

  // discs
  double radius_min = 0.5e-3;   ///< [m]
  double radius_max = 0.75e-3;  ///< [m]
  double density = 2500.0;      ///< of a grain [kg/m3]
  double porosity = 0.10;       ///< of the cloud before it is packed, overlaps not counted [1]

  // grading (grading.hpp)
  double fine_depth = 0.0;    ///< from the surface down discs are as above, larger below; 0: as above everywhere [m]
  double coarse_ratio = 2.0;  ///< radii below over radii above [1]

  // flat joints
  double joint_modulus = 1.5e9;             ///< E* [Pa]
  double joint_stiffness_ratio = 2.5;       ///< kappa [1]
  double tensile_strength = 10e6;           ///< [Pa]
  double cohesion = 50e6;                   ///< [Pa]
  double friction_angle = 0.0;              ///< of bonded elements [rad]
  double friction = 0.577;                  ///< of broken elements [1]
  int elements = 2;                         ///< N_r [1]
  double radius_multiplier = 1.0;           ///< lambda [1]
  double installation_gap = 0.05e-3;        ///< discs closer than this are joined [m]
  double tensile_strength_deviation = 0.0;  ///< standard deviation from joint to joint [Pa]
  double cohesion_deviation = 0.0;          ///< standard deviation from joint to joint [Pa]
  double gapped_fraction = 0.0;             ///< of joints that are not bonded and start apart [1]
  double slit_fraction = 0.0;               ///< of joints that are not bonded and start touching [1]
  double initial_gap = 0.0;                 ///< of gapped joints [m]
  double residual_cohesion = 0.0;           ///< of elements broken in shear [Pa]
  bool drop_to_residual = false;            ///< shear stress at a shear break: false to zero
  double tension_softening = 0.0;           ///< zeta (contact/tension_softening.hpp); 0: none [1]

  // linear contacts: loose discs
  double contact_modulus = 1.5e9;            ///< E* [Pa]
  double contact_stiffness_ratio = 2.5;      ///< kappa [1]
  double contact_friction = 0.577;           ///< [1]
  double contact_damping_ratio = 0.5;        ///< beta, share of critical [1]
  double contact_shear_damping_ratio = 0.0;  ///< beta_s, share of critical [1]

  // packing
  double packing_modulus = 1.0e9;   ///< E* of the frictionless contacts while packing [Pa]
  double packing_damping = 0.7;     ///< local damping while packing [1]
  double packing_pressure = 30e6;   ///< isotropic, by growing all discs; 0: what the cloud gives [Pa]
  double equilibrium_ratio = 1e-4;  ///< packing is calm below this ratio of unbalanced to contact force [1]

  // specimen, when made on its own (a cut brings its own bed size)
  double specimen_width = 50e-3;    ///< [m]
  double specimen_height = 100e-3;  ///< [m]
};

/// Sides of a specimen, in the unit of its keys: from a few grains of clay to a block of 10 m.
inline constexpr base::Range specimen_length_mm{.low = 0.01, .high = 1e4};

/// The sections of the file, bound to `rock` (base/config.hpp).
std::vector<base::Section> describe(Rock& rock);

/// The same without the size of specimens made on their own: all that the behaviour of the rock depends on.
std::vector<base::Section> describe_material(Rock& rock);

/// Reads and checks; throws `base::InputError` with file, line and key.
Rock read_rock(const std::filesystem::path& path);
/// Whether a file that needs a rock holds its tables, instead of naming a file.
bool has_rock_inside(const base::ConfigFile& file);
/// The rock of such a file. What else stands in it is left to the caller.
Rock rock_inside(base::ConfigFile& file);
/// Throws `InputError` for what is no rock; `name` stands in the messages.
Rock parse_rock(std::string_view text, const std::string& name);

}  // namespace bitrock::dem2d
