#pragma once
/// Networks that answer the same whatever they are asked: so a force is rebuilt from given statistics by the very way
/// that a bit in a drill string goes.

#include "surrogate/net/model.hpp"

namespace bitrock::studies {

/// One weightless network an output, in the order of `surrogate::output_names`; ten or seventeen values, none negative.
surrogate::Model constant_model(const surrogate::OutputValues& values);

}  // namespace bitrock::studies
