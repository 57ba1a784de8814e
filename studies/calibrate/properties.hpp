#pragma once
/// The five laboratory numbers that a synthetic rock is calibrated to, and the six micro-parameters that answer for
/// them. Both are short arrays, so that the search can loop over them; the names below say which entry is which.
///
/// | number | from | answered mainly by |
/// |---|---|---|
/// | uniaxial compressive strength | compression test | cohesion over tensile strength of the joints |
/// | direct tensile strength | tension test | tensile strength of the joints |
/// | Young's modulus | tension test | effective modulus E* |
/// | Poisson's ratio | tension test | stiffness ratio kappa |
/// | confined strength | triaxial tests | friction angle of the bonded joints |
///
/// The confined strength is the mean, over the pressures of the target, of the largest stress along the load (s_1 of a
/// triaxial test, the confining pressure included).

#include <array>
#include <string>

#include "base/statistics.hpp"
#include "dem2d/specimen/rock.hpp"

namespace bitrock::studies {

/// The laboratory numbers.
enum class Property {
  ucs,               ///< uniaxial compressive strength [Pa]
  tensile_strength,  ///< in direct tension [Pa]
  youngs_modulus,    ///< E in direct tension [Pa]
  poissons_ratio,    ///< nu in direct tension [1]
  confined_strength  ///< mean of s_1 over the confining pressures [Pa]
};
inline constexpr int property_count = 5;  ///< how many there are

/// Something of each, in this order.
template <class Value>
using PerProperty = std::array<Value, property_count>;

/// How one of them is written: key of the target file and of JSON, name and unit for people.
struct PropertyWords {
  const char* key;      ///< in target files, ends in its unit
  const char* si_key;   ///< in JSON, ends in the SI unit
  const char* name;     ///< "UCS"
  const char* unit;     ///< "MPa"; empty for a plain number
  double si_per_unit;   ///< SI value = written value * si_per_unit
  bool relative_error;  ///< true: judged in percent; false: by the plain difference
};
/// They live as long as the program.
const PropertyWords& words_of(Property property);

/// Numbers of a rock file that a search may change; all are of its [flat_joints].
enum class MicroParameter {
  effective_modulus,  ///< E* [Pa]
  stiffness_ratio,    ///< kappa, normal over shear [1]
  tensile_strength,   ///< mean over the joints [Pa]
  cohesion,           ///< mean over the joints [Pa]
  friction,           ///< of broken elements [1]
  friction_angle      ///< phi of bonded elements [rad]
};
inline constexpr int micro_count = 6;  ///< how many there are

/// SI values: E* [Pa], kappa [1], tensile strength [Pa], cohesion [Pa], friction coefficient of broken elements [1],
/// friction angle of bonded elements [rad].
using Micro = std::array<double, micro_count>;

/// Key of the rock file without its section, and the factor of its unit.
struct MicroWords {
  const char* key;     ///< in rock files, ends in its unit
  const char* name;    ///< for people, without unit
  const char* unit;    ///< "GPa"; empty for a plain number
  double si_per_unit;  ///< SI value = written value * si_per_unit
};
/// They live as long as the program.
const MicroWords& words_of(MicroParameter parameter);

/// Those that the rock has now.
Micro micro_of(const dem2d::Rock& rock);

/// The rock with these micro-parameters. What belongs to a changed one goes with it in proportion: the modulus, ratio
/// and friction of the linear contacts, the scatter of the strengths, the residual cohesion; but never out of the
/// ranges of a rock file. What is not changed stays as it is, bit for bit.
dem2d::Rock with_micro(const dem2d::Rock& rock, const Micro& micro);

/// What a rock file allows of the parameter, in SI.
struct MicroLimits {
  double low, high;  ///< both allowed
};
/// As the reader of rock files checks it (dem2d/specimen/rock.hpp).
MicroLimits limits_of(MicroParameter parameter);

/// The parameter rounded to four digits of its file unit, so that a rock file holds exactly what was tested.
double rounded(MicroParameter parameter, double value);

/// Above it an elastic body would grow when it is pressed: no target, and no measurement that a search may follow.
inline constexpr double largest_poissons_ratio = 0.5;

/// Measured value against the wanted one, in tolerances' own measure: a share of the wanted value, or the difference.
double error_of(Property property, double value, double wanted);

/// Mean and scatter over the seeds of each number; `count` is 0 for a number that was not measured.
struct Evaluation {
  Micro micro{};                        ///< that were tested
  PerProperty<base::Summary> measured;  ///< [Pa], [Pa], [Pa], [1], [Pa]
  std::string failure;                  ///< why nothing was measured; empty when it was
};

/// Its place in `PerProperty`.
inline std::size_t index_of(Property property) {
  return static_cast<std::size_t>(property);
}
/// Its place in `Micro`.
inline std::size_t index_of(MicroParameter parameter) {
  return static_cast<std::size_t>(parameter);
}

/// In the order of `PerProperty`.
inline constexpr std::array all_properties{Property::ucs, Property::tensile_strength, Property::youngs_modulus,
                                           Property::poissons_ratio, Property::confined_strength};
/// In the order of `Micro`.
inline constexpr std::array all_micro_parameters{MicroParameter::effective_modulus, MicroParameter::stiffness_ratio,
                                                 MicroParameter::tensile_strength,  MicroParameter::cohesion,
                                                 MicroParameter::friction,          MicroParameter::friction_angle};

}  // namespace bitrock::studies
