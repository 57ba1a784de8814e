#include "report/embedded.hpp"

// The assembler copies a file as it is, in no time; the same bytes as a C++ array would take the compiler seconds.
// CMakeLists.txt names the files and rebuilds this one when they change.
#define BITROCK_EMBED(symbol, file)                            \
  asm(".pushsection .rodata\n"                                 \
      ".global bitrock_" #symbol                               \
      "_begin\n"                                               \
      ".global bitrock_" #symbol                               \
      "_end\n"                                                 \
      "bitrock_" #symbol "_begin:\n.incbin \"" file            \
      "\"\n"                                                   \
      "bitrock_" #symbol "_end:\n.byte 0\n.popsection\n");     \
  extern "C" const char bitrock_##symbol##_begin[];            \
  extern "C" const char bitrock_##symbol##_end[];              \
  static std::string_view symbol##_bytes() {                   \
    return {bitrock_##symbol##_begin, bitrock_##symbol##_end}; \
  }

BITROCK_EMBED(page_style, BITROCK_PAGE_STYLE)
BITROCK_EMBED(page_script, BITROCK_PAGE_SCRIPT)
#ifdef BITROCK_PLOTLY_SCRIPT
BITROCK_EMBED(plotly_script, BITROCK_PLOTLY_SCRIPT)
BITROCK_EMBED(plotly_licence, BITROCK_PLOTLY_LICENCE)
#else
static std::string_view plotly_script_bytes() {
  return {};
}
static std::string_view plotly_licence_bytes() {
  return {};
}
#endif

namespace report {

std::string_view page_style() {
  return page_style_bytes();
}
std::string_view page_script() {
  return page_script_bytes();
}
bool plotly_available() {
  return !plotly_script_bytes().empty();
}
std::string_view plotly_script() {
  return plotly_script_bytes();
}
std::string_view plotly_licence() {
  return plotly_licence_bytes();
}

}  // namespace report
