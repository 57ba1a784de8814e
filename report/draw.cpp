#include "report/draw.hpp"

#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/temporary_folder.hpp"

namespace bitrock::report {

void draw(const GnuplotFiles& files, const std::filesystem::path& picture) {
  const base::TemporaryFolder folder;
  base::write_whole(folder.path() / "script.gp", files.script);
  base::write_whole(folder.path() / "table.csv", files.table);
  const base::ProgramEnd end =
      base::run_program({"gnuplot", "-d", "-e", "picture = 'picture'; data = 'table.csv'", "script.gp"}, folder.path());
  const std::filesystem::path drawn = folder.path() / "picture";
  if (end.status != 0 || !std::filesystem::exists(drawn)) {
    throw base::SimulationError(
        fmt::format("gnuplot could not draw {} (status {}): {}", picture.string(), end.status, end.output));
  }
  base::write_whole(picture, base::read_whole(drawn));
}

bool can_draw() {
  return base::is_installed("gnuplot");
}

}  // namespace bitrock::report
