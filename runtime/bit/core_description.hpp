#pragma once
/// A bit and a model as the plain numbers that a core is made of (runtime/core/bitrock_runtime.h).

#include <cstdint>
#include <vector>

#include "runtime/bit/bit.hpp"
#include "runtime/core/bitrock_runtime.h"
#include "surrogate/net/model.hpp"

namespace bitrock::runtime {

/// The description of a core, with the storage its pointers need.
struct CoreDescription {
  std::vector<bitrock_cutter> cutters;            ///< what the description points to
  std::vector<std::vector<std::int32_t>> layers;  ///< of each output
  bitrock_description plain{};                    ///< points into `cutters`, `layers` and the model
};

/// The mode that is meant when a bit with this model is asked for `mode`: never `automatic`.
SignalMode mode_for(SignalMode mode, const surrogate::Model& model);

/// A bit and a model as plain numbers. The model must outlive the description. Averages are over 0.1 s.
CoreDescription describe(const Bit& bit, const surrogate::Model& model);

}  // namespace bitrock::runtime
