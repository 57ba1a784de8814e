#include "views/text/source_words.hpp"

#include <fmt/format.h>

namespace bitrock::views {

std::string source_words(const runtime::SourceCase& source, const std::string& model) {
  switch (source.kind) {
    case runtime::SourceKind::none:
      return "none";
    case runtime::SourceKind::sinusoidal:
      return fmt::format("sinusoid, {:g} waves a turn", source.waves_per_turn);
    case runtime::SourceKind::noise:
      return "noise";
    case runtime::SourceKind::bit:
      break;
  }
  return fmt::format("networks (model {})", model.substr(0, 8));
}

}  // namespace bitrock::views
