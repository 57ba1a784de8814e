#pragma once
/// A drilling case as a file says it: string, top drive, bit, rock, excitation, and how long to run. `assemble` makes
/// of it the drill string that the solver takes. The file's keys are in docs/reference/formats.md.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/config.hpp"
#include "base/config_rows.hpp"
#include "runtime/bit/bit.hpp"
#include "runtime/drillstring/drill_string.hpp"
#include "runtime/drillstring/modes.hpp"

namespace bitrock::runtime {

/// How long, and how fine.
struct DrillSchedule {
  double duration = 0.0;    ///< [s]
  double step = 1e-4;       ///< [s]
  double sample = 1e-2;     ///< [s] between two rows of the result; a whole number of steps
  double settling = 0.0;    ///< [s] at the beginning that the summary leaves out
  bool turning = true;      ///< begins at the speed of the drive
  double off_bottom = 0.0;  ///< [m] lift of the bit at the beginning
};

/// How the top drive answers to the torque of the string.
enum class DriveAnswer {
  stiff,        ///< not at all: its speed is imposed
  soft_torque,  ///< as a spring and a damper that cancel its inertia at the period of stick-slip
  matched       ///< with the impedance of the string: no wave comes back
};

/// What the case says of that; 0: by the rules of `soft_torque` and `matched`.
struct DriveControlCase {
  DriveAnswer answer = DriveAnswer::stiff;  ///< how it answers
  double damping = 0.0;                     ///< [N m s/rad] proportional gain
  double period = 0.0;                      ///< [s] it is tuned to; 0: slowest of the string
  double reaction_time = 5e-3;              ///< [s] of a matched drive; a fast motor control has some milliseconds
};

/// A case as its file has it.
struct DrillCase {
  std::string name;                                                 ///< for people
  std::string rock;                                                 ///< the rock the case is about; empty: not said
  std::vector<PipeSection> pipes;                                   ///< from top to bottom; empty: the chains are given
  int axial_lumps = 2, torsional_lumps = 2;                         ///< masses of the string
  Lumping lumping = Lumping::middle;                                ///< where the masses lie
  double axial_damping_ratio = 0.0, torsional_damping_ratio = 0.0;  ///< [1] of a pair
  Chain axial, torsional;    ///< as given; empty where there are pipes, and `axial` where the weight on bit is imposed
  TopDrive drive;            ///< what turns the string
  DriveControlCase control;  ///< how it answers to the string
  Hoist hoist{.autodriller = {.fastest = 0.05}};  ///< what holds the string, by the line alone; the rest: by `assemble`
  double autodriller_time = 5.0;                  ///< [s] in which it answers
  double drive_inertia = 0.0;      ///< [kg m^2] of a drive that imposes torque, or of one with soft torque
  double drive_damping = 0.0;      ///< [N m s/rad] of that drive against the ground
  std::string bit_file;            ///< empty: no bit, or its keys stand in the case itself
  Bit bit;                         ///< without cutters: none
  double bit_mass = 0.0;           ///< [kg] added to the lowest axial lump
  double bit_inertia = 0.0;        ///< [kg m^2] added to the lowest torsional lump; 0 with a bit file: of a cylinder
  double bit_damping = 0.0;        ///< [N m s/rad] of the bit against the ground
  Friction wall_friction;          ///< of the wall on the string
  std::vector<double> wall_force;  ///< [N] of the wall on each torsional lump of the string
  double wall_radius = 0.0;        ///< [m] arm of that friction
  BitRock bit_rock;                ///< `friction_radius` 0 with a bit file: mean radius of its cutters
  double pressure_drop = 0.0, nozzle_area = 0.0;  ///< [Pa], [m^2]
  bool jets_push_up = true;                       ///< the jets lift the bit; otherwise they press it down
  double fluid_density = 0.0;                     ///< [kg/m^3] around the pipes
  SourceCase source;                              ///< what shakes the bit
  DrillSchedule run;                              ///< how long, and how fine
};

/// Throws `InputError` with file, line and key.
DrillCase read_drill_case(base::ConfigFile& file);
/// Throws `InputError` with file and key.
DrillCase read_drill_case(const std::filesystem::path& path);

/// For the reader of a case with another string: the tables that do not speak of the string. Other tables are the
/// caller's, and so is `refuse_unknown`.
DrillCase read_common_tables(base::ConfigFile& file);
/// Then, once the pipes are known: reads the bit file, and checks what must fit together.
void complete(base::ConfigFile& file, DrillCase& drill);

/// The case back from `resolved_toml`, long after: the networks it names need not be there any more. `name` is for
/// messages.
DrillCase recorded_drill_case(std::string_view text, const std::string& name);

/// The case with every value and the bit inside, as a file that is read back to the same bits. It names the networks.
std::string resolved_toml(const DrillCase& drill);

/// For the writer of a case with another string: the tables of `read_common_tables`, and `more`, as one text that is
/// read back to the same bits, the bit inside. `left_out`: tables ("wall") and keys ("run.start") that have no meaning
/// there.
std::string resolved_common_toml(const DrillCase& drill, std::vector<base::Section> more,
                                 const std::vector<std::string>& left_out = {});

/// What people are told of the keys of a drill case.
std::vector<base::KeyRow> drill_keys();

/// The laws at the bit, with the arm of the friction and the jets.
BitRock bit_rock_of(const DrillCase& drill);
/// Of the bit about its axis [kg m^2].
double bit_inertia_of(const DrillCase& drill);
/// The control of the top drive, for a string with this slowest torsional period [s] below a drive at rest; without
/// inertia where the drive is stiff.
DriveControl control_of(const DrillCase& drill, double natural_period);

/// **What** Stiffness of the whole string along its axis, as its block feels it [N/m].
/// **Equation** 1 / k = 1 / k_h + sum of 1 / K_i + 1 / k_r: spring of the hoist, of the pipe between lumps, of the
/// rock.
double stiffness_below_block(const DrillString& string);

/// The weight on bit [N] at which the rock goes away with `speed` [m/s] below a bit that turns with `rotation` [rad/s];
/// 0 where no weight, or any, does that.
double weight_for_advance(const BitRock& bit, double rotation, double speed);

/// Throws `InputError` when the parts do not make a drill string.
DrillString assemble(const DrillCase& drill);

/// What the user should know before a run: a weight on bit that never reaches the threshold, or that no bit bears, a
/// string out of balance at the beginning, and the like.
std::vector<std::string> warnings(const DrillCase& drill, const DrillString& string);

/// Above it bits are not run [N], as far as is known here; endless where the bit is not known.
double most_weight_on_bit(const Bit& bit);

/// The same of the load of the source: one that pushes harder than the weight on bit leaves nothing in balance. Asks
/// `load` for some turns, so it must be one that no run goes on with.
std::vector<std::string> warnings_of_load(const DrillString& string, const BitRockSource& load);

/// **What** Longest stable step of the linear chains with rock spring, broken rock and the steepest friction in place.
/// **Validity** Friction is counted at the static weight on bit; leave room for the peaks of a bouncing bit.
double longest_stable_step(const DrillString& string);

/// Throws `InputError` when the step of the run is longer than that.
void require_stable(const DrillCase& drill, const DrillString& string);

/// The rock's spring as the linear chains feel it.
BitSupport axial_support(const DrillString& string);

/// Natural frequencies [Hz].
struct DrillModes {
  std::vector<double> axial;             ///< [Hz] bit on the rock's spring; empty without an axial chain
  std::vector<double> axial_off_bottom;  ///< [Hz] bit free: the first is 0 without a line; empty without an axial chain
  std::vector<double> torsional;         ///< [Hz] bit free, drive held still
};

/// Natural frequencies of the whole string.
DrillModes drill_modes(const DrillString& string);

}  // namespace bitrock::runtime
