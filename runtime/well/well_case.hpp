#pragma once
/// A drilling case with a `[well]`: the path and width of the hole, the string in it, what the rig does. Bit, rock,
/// excitation and duration have the keys of a case in two dimensions.

#include <filesystem>
#include <string>
#include <vector>

#include "base/config.hpp"
#include "base/config_rows.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/well/rig.hpp"
#include "runtime/well/stress.hpp"

namespace bitrock::runtime {

/// What a pipe of the case needs beside its section.
struct WellPipe {
  PipeSection pipe;                  ///< its length and section
  double segment_length = 10.0;      ///< [m] of its segments, or a little less: a whole number of them
  double contact_diameter = 0.0;     ///< [m] with which it touches the wall, of its tool joints; 0: of the body
  double tool_joint_distance = 0.0;  ///< [m] from one tool joint to the next; 0: none that matter
};

/// A drilling case with a well, as its file says it.
struct WellCase {
  DrillCase drill;                         ///< bit, rock, excitation, run, speed of the drive, mud
  std::vector<SurveyStation> stations;     ///< of the case itself
  std::filesystem::path survey_file;       ///< or a file that the caller reads
  std::vector<HoleSection> hole;           ///< from top to bottom
  std::vector<WellPipe> pipes;             ///< from top to bottom
  MaterialDamping damping;                 ///< of the joints
  Growth growth = Growth::split;           ///< at the table
  double bit_gauge = 0.0;                  ///< [m] diameter with which the bit rubs; 0: it does not
  double bottom_depth = 0.0;               ///< [m] measured depth of the hole at the beginning; 0: there is no bottom
  bool mud_added_mass = false;             ///< mud that moves with the pipe across its axis counts
  double drag_across = 0.0;                ///< [N s/m^2] of the mud
  RigPlan plan;                            ///< what is done
  double autodriller_time = 5.0;           ///< [s] in which it answers: some periods of the first axial mode of 1500 m
  int frames = 400;                        ///< instants of which the run keeps the whole string, besides the beginning
  std::vector<StressPoint> stress_points;  ///< whose history is kept
  bool every_joint = false;                ///< the loads of every joint are kept, too
};

/// The pipe that is so far above the bit [m].
const WellPipe& pipe_at(const WellCase& well, double above_bit);

/// Whether a file is a case with a well.
bool has_well(const std::filesystem::path& file);

/// Throws `InputError` with file, line and key. A survey file is named, not read.
WellCase read_well_case(const std::filesystem::path& file);

/// The string of the case, in the hole along `stations`, at its beginning. Throws `InputError`.
WellString assemble(const WellCase& well);

/// The case with every value, its survey and its bit inside, as a file that is read back to the same bits. It names the
/// networks.
std::string resolved_toml(const WellCase& well);

/// The case back from `resolved_toml`, or from the text of a file, long after: what it names need not be there any more
/// (`stations` are then empty where a survey file gave them, and the bit is not read). `name` is for messages.
WellCase recorded_well_case(std::string_view text, const std::string& name);

/// What people are told of the keys besides those of `drill_keys`.
std::vector<base::KeyRow> well_keys();

/// Throws `InputError` when the step of the run is longer than 0.8 of the longest stable one.
void require_stable(const WellCase& well, const WellString& string);

}  // namespace bitrock::runtime
