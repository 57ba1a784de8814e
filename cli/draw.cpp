#include "cli/draw.hpp"

#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "report/gnuplot_text.hpp"

namespace cli {

void draw(const std::filesystem::path& script, const std::filesystem::path& picture) {
  const std::filesystem::path whole = std::filesystem::absolute(picture);
  const std::string folder = std::filesystem::absolute(script).parent_path().string();
  base::PartFile part(whole);
  const base::ProgramEnd end = base::run_program(
      {"gnuplot", "-e",
       fmt::format("cd {}; picture = {}; load {}", report::quoted(folder), report::quoted(part.name().string()),
                   report::quoted(script.filename().string()))});
  if (end.status != 0) {
    throw base::SimulationError(
        fmt::format("gnuplot could not draw {} (status {}): {}", picture.string(), end.status, end.output));
  }
  part.put_in_place();
}

bool can_draw() {
  return base::is_installed("gnuplot");
}

}  // namespace cli
