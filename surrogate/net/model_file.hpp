#pragma once
/// The model file: `Model` as indented JSON that people can read and that reads back bit for bit. It is checked key by
/// key, because a model that was cut short, edited by hand or made by another version must never end in a wrong force.
/// Layout in docs/reference/formats.md; the version rises whenever an old reader would misunderstand a new file.

#include <filesystem>
#include <string>
#include <string_view>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

inline constexpr const char* model_format = "bitrock-model";  ///< value of the key `format`
inline constexpr int model_format_version = 2;                ///< value of the key `format_version`; no other is read

/// Parameters beyond this are refused. Inputs and outputs are scaled to about 1, so useful parameters are about 1 too;
/// a million means a broken file or a training that diverged.
inline constexpr double largest_parameter = 1e6;

/// The bytes of the file. The same model always gives the same bytes.
std::string model_text(const Model& model);

/// Throws `base::InputError` with `name`, the path of the key, what was seen and what is allowed: for text that is not
/// whole JSON, another format or version, a missing or unknown key, wrong names, units or shapes, numbers that are not
/// finite or out of range.
Model model_from_text(std::string_view text, const std::string& name);

/// As `model_from_text`; also throws `base::InputError` when the file cannot be read.
Model read_model(const std::filesystem::path& path);

/// The same for who asks by speed, depth and rake alone; throws `InputError` for a model with further inputs too.
Model read_cut_model(const std::filesystem::path& path);

/// Throws `base::SimulationError` when the file cannot be written.
void write_model(const std::filesystem::path& path, const Model& model);

}  // namespace bitrock::surrogate
