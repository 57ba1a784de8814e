#include "studies/repeat/again.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/version.hpp"
#include "dem2d/specimen/specimen.hpp"

namespace bitrock::studies {

namespace {

std::string seed_flag(const base::Hdf5Reader& file) {
  return fmt::format(" --seed {:.0f}", file.number_attribute("seed"));
}

}  // namespace

Again again(const base::Hdf5Reader& file) {
  const std::string format = file.text_attribute("format");
  const auto packed_elsewhere = [&](const char* origin) {
    return file.text_attribute(origin) != dem2d::origin_genesis;
  };
  if (format == "bitrock-run") {
    return {.command = "bitrock cut {}" + seed_flag(file),
            .besides = packed_elsewhere("bed_origin")
                           ? "--specimen and the file of its discs, which were packed elsewhere"
                           : ""};
  }
  if (format == "bitrock-specimen") {
    return {.command = "bitrock specimen {}" + seed_flag(file),
            .besides = packed_elsewhere("origin")
                           ? "--from-discs and the table of its discs, which were packed elsewhere"
                           : ""};
  }
  if (format == "bitrock-drill" || format == "bitrock-well") return {.command = "bitrock drill run {}", .besides = ""};
  throw base::InputError(
      fmt::format("{}: a file of format '{}' (must be made by cut, specimen or drill run)", file.name(), format));
}

std::string made_by_another_program(const base::Hdf5Reader& file) {
  const auto said = [&](const char* name) {
    return file.has_attribute(name) ? file.text_attribute(name) : std::string("not said");
  };
  const std::string version = said("version"), commit = said("git_commit");
  if (version == base::version && commit == base::git_commit) return "";
  return fmt::format(
      "{} was made by bitrock {} ({}), this is {} ({}): the same bits only if nothing between the two "
      "touches results",
      file.name(), version, commit, base::version, base::git_commit);
}

}  // namespace bitrock::studies
