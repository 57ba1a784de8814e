#include "views/text/prediction_lines.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace bitrock::views {

std::string prediction_lines(const surrogate::Prediction& prediction, double cut_length) {
  std::string lines;
  for (const auto& [axis, p] : {std::pair{"x", prediction.x}, std::pair{"y", prediction.y}}) {
    lines += fmt::format("{}: A_max {:.4g} kN/m, A_mean {:.4g} kN/m, peaks per metre {:.4g} + {:.4g} + {:.4g}\n", axis,
                         p.amax * 1e-3, p.amean * 1e-3, p.np1, p.np23, p.np4);
    if (cut_length > 0.0) {
      lines +=
          fmt::format("   a cut of {:g} mm: {:.4g} + {:.4g} + {:.4g} peaks\n", base::in_units(cut_length, base::mm),
                      p.np1 * cut_length, p.np23 * cut_length, p.np4 * cut_length);
    }
  }
  if (!prediction.has_moments) return lines;
  const auto& [x_mean, x_sd, y_mean, y_sd, length, brief, correlation] = prediction.moments;
  return lines + fmt::format(
                     "mean and standard deviation: x {:.4g} and {:.4g} kN/m, y {:.4g} and {:.4g} kN/m; correlation "
                     "lengths {:.4g} and {:.4g} mm, correlation of x and y {:.3g}\n",
                     x_mean * 1e-3, x_sd * 1e-3, y_mean * 1e-3, y_sd * 1e-3, length * 1e3, brief * 1e3, correlation);
}

}  // namespace bitrock::views
