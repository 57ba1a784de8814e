// The pages of docs/reference that list what the program reads and writes, from the lists that it reads and writes by:
//   reference_pages keys | flags       a page, to standard output
//   reference_pages arrays FILE.h5     the arrays of a file with unit and meaning, and its attributes, as JSON
// docs/reference/renew.py calls it.
#include <fmt/format.h>
#include <hdf5.h>

#include <string_view>

#include "base/config_rows.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/hdf5_image.hpp"
#include "cli/command.hpp"
#include "cli/program.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "runtime/bit/bit.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/well/well_case.hpp"
#include "studies/calibrate/target.hpp"
#include "studies/campaign/study.hpp"

using namespace bitrock;

namespace {

/// Text of a cell: a bar would end it.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("|\n", at)) != std::string::npos; at += 2) {
    text.replace(at, 1, text[at] == '|' ? "\\|" : "; ");
  }
  return text;
}

void print_keys(const char* file, const std::vector<base::KeyRow>& rows) {
  fmt::print("\n## {}\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n", file);
  for (const base::KeyRow& row : rows) {
    const std::string table = row.table.empty() ? "" : row.table.front() == '[' ? "[" + row.table + "]" : row.table;
    const std::string key = row.table.empty() ? row.key : fmt::format("{}.{}", table, row.key);
    const std::string other = row.other.empty() ? "" : fmt::format(" or `{}`", row.other);
    fmt::print("| `{}`{} | {} | {} | {} |\n", key, other, cell(row.standard), cell(row.allowed), cell(row.meaning));
  }
}

void print_all_keys() {
  fmt::print(
      "# Keys of the input files\n\n"
      "Made by `docs/reference/renew.py` from the lists that the program reads by; do not change it by hand. A key "
      "ends "
      "in its unit, and default and allowed values are in that unit. Where there are two keys, of which a file has "
      "one, "
      "they are in the unit of the first. *none*: the key may be left out, and nothing takes its place. What the files "
      "are for: [formats.md](formats.md).\n");
  dem2d::Rock rock;
  print_keys("Rock", base::key_rows(dem2d::describe(rock)));
  print_keys("Target of a calibration", studies::target_keys());
  dem2d::CutCase cut;
  print_keys("Cut", base::key_rows(dem2d::describe(cut)));
  print_keys("Study", studies::study_keys());
  print_keys("Bit", runtime::bit_keys());
  print_keys("Drilling case", runtime::drill_keys());
  print_keys("Drilling case with a well, besides", runtime::well_keys());
}

/// "whole number, 0 to 10" for "INT:INT in [0 - 10]", as the library of the flags has it.
std::string kind_of(const CLI::Option& option) {
  std::string kind = option.get_type_name();
  if (const std::size_t colon = kind.find(':'); colon != std::string::npos) kind.erase(0, colon + 1);
  for (const auto& [theirs, ours] : {std::pair{"INT in [", "whole number, "},
                                     {"FLOAT in [", "number, "},
                                     {"NUMBER ", "number, "},
                                     {" - ", " to "},
                                     {"]", ""},
                                     {"TEXT", "text"},
                                     {"INT", "whole number"}}) {
    if (const std::size_t at = kind.find(theirs); at != std::string::npos)
      kind.replace(at, std::string_view(theirs).size(), ours);
  }
  return kind;
}

std::string default_of(const CLI::Option& option) {
  const bool side_by_side = option.get_name() == "--jobs" || option.get_name() == "--threads";
  if (option.get_required()) return "required";
  if (side_by_side && option.get_default_str() == std::to_string(cli::cores())) return "all cores";
  return option.get_default_str();
}

void print_flags(const CLI::App& command, const std::string& above) {
  const std::string name = above.empty() ? command.get_name() : above + " " + command.get_name();
  fmt::print("\n## {}\n\n{}\n\n| flag | takes | default | meaning |\n|---|---|---|---|\n", name,
             command.get_description());
  for (const CLI::Option* option : command.get_options()) {
    if (option == command.get_help_ptr()) continue;
    const bool takes = option->get_type_size_max() > 0;
    fmt::print("| `{}` | {} | {} | {} |\n", option->get_name(!option->nonpositional(), true),
               takes ? cell(kind_of(*option)) : "", takes ? cell(default_of(*option)) : "",
               cell(option->get_description()));
  }
  for (const CLI::App* action : command.get_subcommands({})) print_flags(*action, name);
}

int print_all_flags() {
  if (cli::cores() == 1) {
    fmt::print(stderr, "reference_pages: on one core a default of 1 and one of all cores look the same\n");
    return 77;
  }
  fmt::print(
      "# Flags of the program\n\n"
      "Made by `docs/reference/renew.py` from what the program declares; do not change it by hand. Every subcommand "
      "also has "
      "`-h,--help`.\n");
  CLI::App app;
  cli::declare_program(app);
  print_flags(app, "");
  return 0;
}

/// What an array says of itself (`base::Hdf5Writer::array`).
std::string text_of(hid_t array, const char* name) {
  const base::Hdf5Handle attribute(H5Aopen(array, name, H5P_DEFAULT), H5Aclose);
  const base::Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), text.data()) < 0) throw base::InputError(std::string("no text ") + name);
  return text.substr(0, text.find('\0'));
}

void print_arrays(const std::string& path) {
  const std::string bytes = base::read_whole(path);
  const base::Hdf5Image image = base::hdf5_image(bytes, path);
  const base::Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  nlohmann::json found{{"arrays", nlohmann::json::array()}, {"attributes", nlohmann::json::array()}};
  for (const auto& [name, array] : image.arrays) {
    const base::Hdf5Handle data(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
    found["arrays"].push_back(
        {{"name", name}, {"unit", text_of(data.id(), "units")}, {"meaning", text_of(data.id(), "long_name")}});
  }
  for (const auto& [name, attribute] : image.attributes) found["attributes"].push_back(name);
  fmt::print("{}\n", found.dump());
}

}  // namespace

// A fault here is one of the build, and may end the program.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  const std::string_view page = argc > 1 ? argv[1] : "";
  if (page == "keys" && argc == 2) {
    print_all_keys();
  } else if (page == "flags" && argc == 2) {
    return print_all_flags();
  } else if (page == "arrays" && argc == 3) {
    print_arrays(argv[2]);
  } else {
    fmt::print(stderr, "usage: reference_pages keys | flags | arrays FILE.h5\n");
    return 2;
  }
  return 0;
}
