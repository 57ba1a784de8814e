#pragma once
/// A bit in a rock as a file that other simulation programs load: an FMU for co-simulation after FMI 2.0 [Fmi2]. It is
/// a ZIP archive of a description of its variables, the library that computes (carried inside this program), and the
/// bit and the model as plain numbers. What the library does is said in `bit_slave.hpp`.

#include <string>

#include "runtime/bit/bit.hpp"
#include "runtime/core/bitrock_runtime.h"
#include "runtime/fmu/archive.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::fmu {

/// The same bit, model and program always give the same bytes. Throws `InputError` when a core cannot be made of the
/// bit and the model, or when this program carries no library.
FmuFile fmu_file(const runtime::Bit& bit, const surrogate::Model& model);

/// The bytes of `resources/bit.block`. The guid is left empty when it is not known yet.
std::string bit_block(const bitrock_description& description, double threshold_weight, const std::string& guid);

/// The text of `modelDescription.xml`.
std::string model_description(const runtime::Bit& bit, const surrogate::Model& model, const std::string& guid);

}  // namespace bitrock::fmu
