#pragma once
/// What a `cut.toml` says: one straight cut of one cutter through a bed of rock. Plain data, SI inside.

#include <filesystem>
#include <string>
#include <vector>

#include "base/config.hpp"
#include "dem2d/fluid/mud.hpp"
#include "dem2d/specimen/rock.hpp"
#include "dem2d/step/step.hpp"
#include "dem2d/tool/cutter.hpp"

namespace bitrock::dem2d {

struct CutCase {
  std::string rock_file;  ///< as written, relative to the case file; `rock` holds its content
  Rock rock;              ///< that is cut

  double cutter_speed = 0.0;  ///< [m/s]
  double depth_of_cut = 0.0;  ///< [m]
  double back_rake = 0.0;     ///< [rad]
  double run_in = 0.0;        ///< travel from just before the rock that does not count in forces and peaks [m]
  double cut_length = 30e-3;  ///< travel of the cutter after that [m]

  double cutter_diameter = 13e-3;  ///< length of the face [m]
  double cutter_thickness = 8e-3;  ///< [m]
  double cutter_friction = 0.3;    ///< between cutter and rock [1]
  double cutter_clearance = 0.0;   ///< rise of the underside; 0: the back rake [rad]
  double cutter_chamfer = 0.0;     ///< from the edge up the face, at 45 degrees to it; 0: sharp [m]
  double cutter_wear_flat = 0.0;   ///< along the cut; 0: none [m]

  double bed_length = 60e-3;                       ///< [m]
  double bed_height = 20e-3;                       ///< [m]
  double moving_ahead = 0.0, moving_behind = 0.0;  ///< rock ahead of the tip and behind it that moves; 0: all of it [m]

  double local_damping = 0.1;              ///< alpha while cutting [1]
  double sampling_distance = 20e-6;        ///< travel between two samples of the force history [m]
  double step_factor = usual_step_factor;  ///< of the longest step that is stable by its bound (step/step.hpp) [1]
  double domain_margin = 20e-3;            ///< discs farther than this from the bed are removed [m]

  double mud_pressure = 0.0;         ///< on what mud cannot enter (fluid/mud.hpp); 0: none, as in the article [Pa]
  std::string debris = "sealed";     ///< "sealed" or "drained"
  std::string cutter_face = "open";  ///< "open" or "sealed": whether mud comes between cutter and debris
  double seal_gap_over_radius =
      usual_seal_gap_over_radius;  ///< widest gap that mud does not enter, over the smallest radius [1]
};

inline constexpr const char *debris_sealed = "sealed", *debris_drained = "drained";  ///< of `CutCase::debris`
inline constexpr const char *face_open = "open", *face_sealed = "sealed";            ///< of `CutCase::cutter_face`

/// What a case may be, in the units of its keys: ten times beyond what cutters do, near enough to catch a slipped unit
/// (depths of cut are 0.1 to 10 mm). The rock ahead of a face that leans more than 60 degrees is not cut but ploughed.
inline constexpr base::Range cutter_speed_m_per_s{.low = 0.0, .high = 50.0, .low_open = true};
inline constexpr base::Range depth_of_cut_mm{.low = 0.01, .high = 100.0};  ///< allowed depths
inline constexpr base::Range back_rake_deg{.low = 0.0, .high = 60.0};      ///< allowed back rakes
/// Allowed pressures of the mud: ten times that of the deepest wells; 0 without mud.
inline constexpr base::Range fluid_pressure_MPa{.low = 0.01, .high = 1e3, .or_zero = true};

/// The sections of the file without the rock, bound to `cut`.
std::vector<base::Section> describe(CutCase& cut);

/// The cutter of the case.
CutterShape cutter_shape(const CutCase& cut);

/// Without mud its table means nothing and is left out of what is kept and compared.
void leave_out_unused(std::vector<base::Section>& sections, const CutCase& cut);

/// Reads the case and the rock it names, or holds, checked together. Throws `base::InputError`.
CutCase read_cut_case(const std::filesystem::path& path);

/// Checks that concern several values at once (depth against bed, length against bed ...); throws `base::InputError`
/// whose message starts with `source`.
void check_cut_case(const CutCase& cut, const std::string& source);

/// What is allowed but hardly wanted, in words: a depth of cut, or a cutter, below one grain.
std::vector<std::string> warnings(const CutCase& cut);

/// Case and rock as one TOML text: everything the result depends on but the seed. To 15 digits: what is compared.
std::string resolved_toml(const CutCase& cut);

/// The same, read back to the same bits: a file of which the cut can be made again.
std::string exact_toml(const CutCase& cut);

/// Reads such a text back.
CutCase parse_resolved(const std::string& text, const std::string& name);

}  // namespace bitrock::dem2d
