#include "cli/strict_numbers.hpp"

#include <fmt/format.h>

#include <string>

#include "base/number.hpp"

namespace bitrock::cli {

namespace {

/// Leaves a text that is a number as the library reads it: leading zeros would make it octal there.
std::string normalise_whole(std::string& text) {
  const std::optional<std::int64_t> value = base::whole_number_in(text);
  if (!value) return fmt::format("'{}' (must be a whole number in decimal digits)", text);
  text = std::to_string(*value);
  return "";
}

std::string normalise_whole_from_0(std::string& text) {
  const std::optional<std::int64_t> value = base::whole_number_in(text);
  if (!value || *value < 0) return fmt::format("'{}' (must be a whole number in decimal digits, 0 or above)", text);
  text = std::to_string(*value);
  return "";
}

std::string check_real(std::string& text) {
  return base::number_in(text) ? "" : base::why_no_number(text);
}

/// By what the library calls the type of the option.
void make_strict(CLI::Option& option) {
  const std::string type = option.get_type_name();
  // `transform` puts the check before those that are there already, which see the normalised text.
  if (type.starts_with("INT")) option.transform(CLI::Validator(normalise_whole, "", "decimal"));
  if (type.starts_with("UINT")) option.transform(CLI::Validator(normalise_whole_from_0, "", "decimal"));
  if (type.starts_with("FLOAT")) option.transform(CLI::Validator(check_real, "", "decimal"));
}

}  // namespace

void read_numbers_strictly(CLI::App& app) {
  const auto all = [](CLI::App*) { return true; };
  for (CLI::Option* option : app.get_options()) make_strict(*option);
  for (CLI::App* command : app.get_subcommands(all)) read_numbers_strictly(*command);
}

}  // namespace bitrock::cli
