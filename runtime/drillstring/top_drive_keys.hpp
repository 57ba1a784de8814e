#pragma once
/// Keys of `[top_drive]` that only some drives and hoists make use of: refused, and not written, where they say
/// nothing. So texts of older cases stay valid, and no key of a file is passed over in silence.

#include <vector>

#include "base/config.hpp"
#include "runtime/drillstring/drill_case.hpp"

namespace bitrock::runtime {

/// Refuses keys of the file that say nothing, and drives and hoists that lack a key or do not suit the string. `axial`:
/// it has an axial chain.
void check_top_drive(const base::ConfigFile& file, const DrillCase& drill, bool axial);

/// Takes the keys that say nothing out of what is written.
void leave_out_unused_of_top_drive(std::vector<base::Section>& sections, const DrillCase& drill);

}  // namespace bitrock::runtime
