#pragma once
/// Inputs of a model beyond speed, depth and rake: the pressure of the mud, and properties of the rock. They vary over
/// a data set, but not while a bit drills: `held` makes of a model with further inputs one without, for a runtime, a
/// bit or an export.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// The pressure of the mud on the rock. A table without such a column was cut without mud, at 0.
inline constexpr std::string_view pressure_input = "fluid_pressure_MPa";

/// Other further inputs are properties of the rock: their columns begin with this.
inline constexpr std::string_view rock_input_begins = "rock_";

/// Whether a column of this name is a further input: `pressure_input`, or one that begins with `rock_`.
bool is_further_input(std::string_view name);

/// The unit at the end of a name: "MPa" of rock_ucs_MPa. "1" when it ends in none of: MPa, GPa, mm, um, m, deg,
/// kg_per_m3, MPa_sqrt_m.
std::string_view unit_at_end(std::string_view name);

/// The inputs of a model behind speed, depth and rake.
std::span<const Variable> further_inputs(const Model& model);

/// "fluid_pressure_MPa, rock_ucs_MPa"; empty when the model has none.
std::string further_names(const Model& model);

/// From texts "NAME=VALUE". Throws `base::InputError` for another form and for a value that is no finite number.
std::vector<HeldInput> held_inputs(std::span<const std::string> texts);

/// The values of the further inputs in the order of the model. Throws `base::InputError` when `given` lacks one, names
/// one twice or one that the model has not.
std::vector<double> further_values(const Model& model, std::span<const HeldInput> given);

/// **What** The model at fixed values of its further inputs: it asks for speed, depth and rake alone, and its answers
/// are those of `model` to the rounding of a sum.
/// **Equation** of the first layer, W s + b with scaled inputs s = (s_c, s_f): W_c s_c + b', b' = b + W_f s_f.
/// **Symbols** c: speed, depth, rake; f: further inputs; s = (value - offset) / scale.
/// **Source** derived here.
/// A pressure that is held becomes the pressure of the cuts in the provenance. Throws as `further_values`, and when a
/// value is outside the training range.
Model held(const Model& model, std::span<const HeldInput> given);

/// Throws `base::InputError` beginning with `source` for a model with further inputs, and says how to hold them.
void require_no_further_inputs(const Model& model, const std::string& source);

}  // namespace bitrock::surrogate
