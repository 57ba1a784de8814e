#pragma once
/// The model as one MATLAB function, for MATLAB, Octave and Simulink's function block, and for typing it into tools
/// that know neither C nor MATLAB: it uses loops and ifs only, no matrix operations. It takes many conditions at a
/// time, one a row, and gives as many rows; conditions in another form are an error.
///
/// **Equation** that of `predict`, in the same order of operations. **Symbols** SI in and out (`columns.hpp`).

#include <string>
#include <string_view>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// The text of the file `name`.m: the function must be called like its file. Throws `base::InputError` when the name is
/// no identifier.
std::string matlab_source(const Model& model, std::string_view name);

}  // namespace bitrock::surrogate
