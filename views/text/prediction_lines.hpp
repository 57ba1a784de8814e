#pragma once
/// What `predict` tells.

#include <string>

#include "surrogate/net/model.hpp"

namespace bitrock::views {

/// The five statistics along x and y, then the moments of a model that has them. With a `cut_length` [m] above 0 also
/// how many peaks a cut of that length has.
std::string prediction_lines(const surrogate::Prediction& prediction, double cut_length);

}  // namespace bitrock::views
