#pragma once
/// What `signal` tells of the force on a bit that turns and advances steadily.

#include <string>

#include "runtime/bit/constant_speed.hpp"

namespace bitrock::views {

/// How the bit turns and drills, then mean and highest force and torque.
std::string signal_lines(const runtime::Bit& bit, const runtime::ConstantSpeed& drive,
                         const runtime::SignalSummary& summary);

}  // namespace bitrock::views
