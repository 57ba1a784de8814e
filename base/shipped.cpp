#include "base/shipped.hpp"

namespace bitrock::base {

std::filesystem::path or_shipped(const std::filesystem::path& path,
                                 const std::optional<std::filesystem::path>& data_folder) {
  const std::filesystem::path plain = path.lexically_normal();
  std::error_code error;
  if (!data_folder || plain.is_absolute() || plain.empty() || *plain.begin() != shipped_folder ||
      std::filesystem::exists(plain, error))
    return path;
  const std::filesystem::path shipped = *data_folder / plain;
  return std::filesystem::exists(shipped, error) ? shipped : path;
}

}  // namespace bitrock::base
