#pragma once
/// Files that are carried inside the library, byte for byte, so that a report can be written without looking for
/// anything on the disk: the page's own style and script, and the plot library with its licence. The plot library comes
/// from npm when the project is configured; where that was not possible it is absent.

#include <string_view>

namespace bitrock::report {

std::string_view page_style();    ///< report/page.css
std::string_view page_script();   ///< report/page.js
std::string_view space_script();  ///< report/space_view.js

bool plotly_available();
/// Both empty when `plotly_available()` is false.
std::string_view plotly_script();
std::string_view plotly_licence();

}  // namespace bitrock::report
