#include "runtime/fmu/archive.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/zip.hpp"

namespace bitrock::fmu {

namespace {

/// In the usual form of a guid: the fingerprint of the content, and that of the content with a letter behind it.
std::string guid_of(std::string content) {
  const std::string first = base::fingerprint_text(content);
  content += 'g';
  const std::string second = base::fingerprint_text(content);
  return fmt::format("{{{}-{}-{}-{}-{}}}", first.substr(0, 8), first.substr(8, 4), first.substr(12, 4),
                     second.substr(0, 4), second.substr(4));
}

}  // namespace

FmuFile packed(Inside inside, const char* identifier, const char* resource,
               const std::function<std::string(const std::string&)>& block_with,
               const std::function<std::string(const std::string&)>& description_with) {
  const std::vector<Library> carried = libraries(inside);
  std::string content = block_with("") + description_with("");
  for (const Library& library : carried) content += library.bytes;
  FmuFile file{.guid = guid_of(std::move(content))};

  const std::string block = block_with(file.guid), xml = description_with(file.guid);
  std::vector<base::ZipEntry> entries{{"modelDescription.xml", xml}};
  for (const Library& library : carried) {
    entries.push_back(
        {fmt::format("binaries/{}/{}{}", library.platform, identifier, library.extension), library.bytes});
    file.platforms.emplace_back(library.platform);
  }
  entries.push_back({fmt::format("resources/{}", resource), block});
  file.bytes = base::zip_stored(entries);
  return file;
}

}  // namespace bitrock::fmu
