#pragma once
/// A drilling case as a file that other simulation programs load: an FMU for co-simulation after FMI 2.0 [Fmi2] of the
/// whole drill string with its bit, in two dimensions or in a well. What its library does is said in
/// `string_slave.hpp`.

#include <optional>

#include "runtime/fmu/archive.hpp"
#include "runtime/fmu/string_block.hpp"
#include "runtime/well/well_run.hpp"

namespace bitrock::fmu {

/// The same case, model and program always give the same bytes. Throws `InputError` where `run_drill` would, when a
/// core cannot be made of the bit and the model, or when this program carries no library.
FmuFile fmu_file(const runtime::DrillCase& drill, const std::optional<surrogate::Model>& model);

/// The same of a case with a well, whose stations are known. Brings the string to rest, which takes as long as 12 s of
/// a run.
FmuFile fmu_file(const runtime::WellCase& well, const std::optional<surrogate::Model>& model);

/// The bytes of `resources/string.block`. `bit`: those of a bit block, or none. The guid is left empty when it is not
/// known yet.
std::string string_block(const StringContent& content, const std::string& bit, const std::string& guid);

}  // namespace bitrock::fmu
