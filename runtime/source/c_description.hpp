#pragma once
/// A bit in a rock as one C header: the numbers of the bit, of its signal and of the networks as a constant of type
/// `bitrock_description`, from which bitrock_core_create makes the bit (runtime/core/bitrock_runtime.h). So a program
/// in C needs the header, libbitrock_runtime.so and nothing that reads files.

#include <string>
#include <string_view>

#include "runtime/bit/bit.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::runtime {

/// The text of the header, C99 and C++. All its names begin with `prefix`; the constant is `prefix`_description. Every
/// number reads back to the same bits, so the force is that of `BitForce`. The same bit, model and prefix always give
/// the same text. Throws `InputError` when a core cannot be made of the bit and the model, or the prefix is no
/// identifier.
std::string c_description(const Bit& bit, const surrogate::Model& model, std::string_view prefix);

}  // namespace bitrock::runtime
