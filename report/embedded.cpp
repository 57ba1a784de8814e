#include "report/embedded.hpp"

#include "base/embed.hpp"

// CMakeLists.txt names the files and rebuilds this one when they change.
BITROCK_EMBED(page_style, BITROCK_PAGE_STYLE)
BITROCK_EMBED(page_script, BITROCK_PAGE_SCRIPT)
BITROCK_EMBED(space_script, BITROCK_SPACE_SCRIPT)
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

namespace bitrock::report {

std::string_view page_style() {
  return page_style_bytes();
}
std::string_view page_script() {
  return page_script_bytes();
}
std::string_view space_script() {
  return space_script_bytes();
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

}  // namespace bitrock::report
