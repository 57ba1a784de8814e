#pragma once
/// Text made safe to stand inside the page: HTML text, JSON inside a script element, names. Everything a caller hands
/// to this module passes through here once; nobody else writes raw text.

#include <string>
#include <string_view>

namespace bitrock::report {

/// Text as `base::printable` shows it, with `&`, `<`, `>`, `"` and `'` as character references: safe as HTML text,
/// inside a quoted attribute, and in the plot library, which reads a few tags and the same references in its labels
/// [HtmlStandard, on serialising HTML].
std::string html_text(std::string_view text);

/// JSON text whose `<`, `>` and `&` are written as \u escapes: still the same JSON, but no value in it can end the
/// script element that carries it (`</script>`, `<!--`) [HtmlStandard, on the contents of script elements].
std::string script_json(std::string_view json);

/// Lower-case ASCII letters and digits, everything else one '-': a name for a file or an anchor. Never empty.
std::string slug(std::string_view text);

}  // namespace bitrock::report
