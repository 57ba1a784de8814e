#pragma once
/// What the cutters of a bit ask of the networks while it turns and drills steadily, against what these have learnt.

#include <string>

#include "runtime/bit/bit.hpp"
#include "surrogate/net/trained_range.hpp"

namespace bitrock::runtime {

/// Lowest and highest over the cutters. `rotation` [rad/s], `rate_of_penetration` [m/s]; a bit with at least one
/// cutter.
surrogate::AskedRanges asked_ranges(const Bit& bit, double rotation, double rate_of_penetration);

/// Every input that is asked outside its range, and by how much; empty when none is.
std::string asked_outside(const Bit& bit, const surrogate::Model& model, double rotation, double rate_of_penetration);

/// The same of the back rakes alone, which do not depend on the motion.
std::string rakes_outside(const Bit& bit, const surrogate::Model& model);

}  // namespace bitrock::runtime
