#pragma once
/// An FMU as `bitrock export fmu` writes it, unpacked by somebody else (CMake's libarchive), its description read by
/// somebody else (Expat).

#include <expat.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "runtime/bit/bit.hpp"
#include "surrogate/net/model_file.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/export/fmu_importer.hpp"
#include "tests/export/mixed_model.hpp"

using namespace bitrock;

namespace fmu_test {

namespace fs = std::filesystem;

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;

  const std::string& at(const std::string& attribute) const { return attributes.at(attribute); }
  bool has(const std::string& attribute) const { return attributes.count(attribute) == 1; }
  const Element& child(const std::string& wanted) const {
    for (const Element& element : children) {
      if (element.name == wanted) return element;
    }
    throw std::runtime_error("no element " + wanted + " in " + name);
  }
};

/// The root element; throws when the text is not well-formed.
inline Element parse(const std::string& text) {
  struct Stack {
    Element document;
    std::vector<Element*> open{&document};
  } stack;
  XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &stack);
  XML_SetElementHandler(
      parser,
      [](void* data, const char* name, const char** attributes) {
        auto& open = static_cast<Stack*>(data)->open;
        Element& made = open.back()->children.emplace_back();
        made.name = name;
        for (; *attributes != nullptr; attributes += 2) made.attributes[attributes[0]] = attributes[1];
        open.push_back(&made);
      },
      [](void* data, const char*) { static_cast<Stack*>(data)->open.pop_back(); });
  const bool good = XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_OK;
  const std::string problem =
      good ? ""
           : fmt::format("line {}: {}", XML_GetCurrentLineNumber(parser), XML_ErrorString(XML_GetErrorCode(parser)));
  XML_ParserFree(parser);
  if (!good) throw std::runtime_error(problem);
  return stack.document.children.at(0);
}

/// What tests of any FMU do with its files.
class FmuFiles : public testing::Test {
 protected:
  static std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

  static void unpack(const fs::path& fmu, const fs::path& folder) {
    fs::create_directories(folder);
    const std::string command = "cd " + quoted(folder) + " && " BITROCK_CMAKE " -E tar xf " + quoted(fmu);
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  /// As importers make it: everything but letters, digits and / . _ - is encoded.
  static std::string uri(const fs::path& path) {
    std::string text = "file://";
    for (const char c : path.string()) {
      const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("/._-", c) != nullptr;
      text += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return text;
  }
};

class Fmu : public FmuFiles {
 protected:
  const scratch::Folder dir{"fmu 100%"};  // its URI needs %20 and %25
  const fs::path model_file = dir / "model.json";
  const fs::path bit_file = fs::path(BITROCK_SOURCE_DIR) / "campaigns/bits/pdc15.toml";
  const fs::path unpacked = dir / "unpacked";
  const surrogate::Model model = mixed::model();
  const runtime::Bit bit = runtime::read_bit(bit_file);
  std::string description_text, guid, resources;
  importer::Library library{};

  void SetUp() override {
    surrogate::write_model(model_file, model);
    const auto outcome = program::run("export fmu " + quoted(model_file) + " " + quoted(bit_file) + " -o " +
                                      quoted(dir / "bit.fmu") + " --json " + quoted(dir / "said.json"));
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    unpack(dir / "bit.fmu", unpacked);
    description_text = base::read_whole(unpacked / "modelDescription.xml");
    guid = parse(description_text).at("guid");
    resources = uri(unpacked / "resources");
    library = importer::load((unpacked / "binaries/linux64/bitrock_bit.so").string());
  }
};

}  // namespace fmu_test
