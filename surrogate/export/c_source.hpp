#pragma once
/// The model as one file of C99 (which is C++ too) that needs nothing but the C mathematics library: the way into
/// programs that take source text or a C function. It takes no memory, keeps no state and does not fail, so it may be
/// called from a real-time loop and from several threads.
///
/// **Equation** that of `predict`, in the same order of operations on the same numbers of 64 bits: compiled without
/// fused multiply-add and with the same mathematics library, it gives the same bits.
/// **Symbols** SI in and out (`columns.hpp`).
/// **Validity** as `predict`: outside the training range it extrapolates, and says so by its answer. Compilers must
/// keep not-a-number (no -ffast-math).

#include <string>
#include <string_view>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// The text of the file. All its names begin with `prefix`, so that several models can live in one program. The same
/// model and prefix always give the same text. Throws `base::InputError` when the prefix is no identifier.
std::string c_source(const Model& model, std::string_view prefix);

}  // namespace bitrock::surrogate
