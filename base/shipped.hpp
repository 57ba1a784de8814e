#pragma once
/// The files that bitrock brings along lie in `campaigns/` of a folder that the program, or the Python package, finds
/// from its own place. This is the one rule by which a name means one of them.

#include <filesystem>
#include <optional>

namespace bitrock::base {

/// First part of the path of every file that bitrock brings along.
inline constexpr const char* shipped_folder = "campaigns";

/// `campaigns/...` that is not to be found from here means the file of that name in `data_folder`, where that has it;
/// what is here comes first. Any other path stays as it is.
std::filesystem::path or_shipped(const std::filesystem::path& path,
                                 const std::optional<std::filesystem::path>& data_folder);

}  // namespace bitrock::base
