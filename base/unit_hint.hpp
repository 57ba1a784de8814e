#pragma once
/// The unit that a number out of range may stand in. Most such numbers are right in another unit: 34.3e6 where MPa are
/// meant is 34.3 MPa in Pa, 0.013 where mm are meant is 13 mm in m.

#include <string>
#include <string_view>

#include "base/config.hpp"

namespace bitrock::base {

/// "is it in Pa? Then write 34.3" when `value`, refused by `allowed`, would be allowed in another unit than the one
/// `key` ends in (`ucs_MPa`, `--width-mm`), the one that brings it nearest to the middle of what is allowed; empty
/// otherwise, and for a number just outside.
std::string unit_hint(std::string_view key, double value, const Range& allowed);

/// "must be above 0 and at most 5000; is it in Pa? Then write 34.3": what to say of a number out of range.
std::string out_of_range(std::string_view key, double value, const Range& allowed);

}  // namespace bitrock::base
