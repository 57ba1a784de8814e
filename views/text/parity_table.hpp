#pragma once
/// What `parity` tells: network against DEM, beside what the scatter of the data alone gives.

#include <string>

#include "surrogate/train/parity.hpp"

namespace bitrock::views {

/// A row a network, of the cases held out where there are some.
std::string parity_table(const surrogate::Parity& parity);

}  // namespace bitrock::views
