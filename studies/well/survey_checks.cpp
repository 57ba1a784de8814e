#include "studies/well/survey_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

using base::deg, base::in_units, runtime::SurveyStation;

// The deepest wells have 15 km [m]; more is a slipped unit.
constexpr double deepest = 2e4;

// Between two stations that look in nearly opposite directions the path lies in no certain plane: an error of 0.1
// degree in one of them turns it by 0.1/sin(175 degrees), more than a degree. Derived here.
constexpr double largest_turn = 175.0 * deg;

// Of good surveys [rad/m], [m], [m]: few wells turn by more than 10 degrees per 30 m, and stations stand a joint or a
// stand of pipe apart (9 to 29 m).
constexpr double sharp_dogleg = 30.0 * deg / 30.0, wide_spacing = 50.0, tvd_tolerance = 0.5;
constexpr double straight = 1.0 * deg;  ///< a turn below which it does not matter how far stations stand apart

[[noreturn]] void refuse(const SurveyRows& rows, std::size_t i, const std::string& what) {
  throw base::InputError(fmt::format("{}:{}: {}", rows.source, rows.lines[i], what));
}

void require_station(const SurveyRows& rows, std::size_t i) {
  const SurveyStation& station = rows.stations[i];
  const auto value = [](double si, const SurveyUnit& unit) {
    return fmt::format("{:.8g} {}", in_units(si, unit.si), unit.name);
  };
  const double md = station.measured_depth, inclination = station.inclination;
  if (!(md >= 0.0 && md <= deepest)) {
    refuse(rows, i,
           fmt::format("measured depth {} (from 0 to {}; is it in another unit?)", value(md, rows.length),
                       value(deepest, rows.length)));
  }
  if (!(inclination >= 0.0 && inclination <= std::numbers::pi)) {
    const char* const hint = inclination < 0.0
                                 ? "; is it a dip, from the horizontal, or does it stand for a missing value?"
                                 : "; are the angles in another unit?";
    refuse(rows, i,
           fmt::format("inclination {} (from 0, straight down, to {}{})", value(inclination, rows.inclination),
                       value(std::numbers::pi, rows.inclination), hint));
  }
  if (!(std::abs(station.azimuth) <= 2.0 * std::numbers::pi)) {
    refuse(rows, i,
           fmt::format("azimuth {} (from 0, north, over {}, east, to {})", value(station.azimuth, rows.azimuth),
                       value(0.5 * std::numbers::pi, rows.azimuth), value(2.0 * std::numbers::pi, rows.azimuth)));
  }
}

void require_step(const SurveyRows& rows, std::size_t i) {
  const SurveyStation &above = rows.stations[i - 1], &below = rows.stations[i];
  if (!(below.measured_depth > above.measured_depth)) {
    refuse(rows, i,
           fmt::format("measured depth {:.8g} {} below {:.8g} {} (must grow from row to row)",
                       in_units(below.measured_depth, rows.length.si), rows.length.name,
                       in_units(above.measured_depth, rows.length.si), rows.length.name));
  }
  const double turn = runtime::angle_between(tangent_of(above), tangent_of(below));
  if (turn > largest_turn) {
    refuse(rows, i,
           fmt::format("the hole turns by {:.4g} degrees to its opposite direction within {:.4g} m (no path "
                       "follows from that; look at inclination and azimuth)",
                       turn / deg, below.measured_depth - above.measured_depth));
  }
}

/// Counts what is found of one kind and keeps the worst.
struct Worst {
  double value = 0.0;
  std::size_t at = 0;
  int count = 0;

  void add(double found, std::size_t place) {
    ++count;
    if (found > value) *this = {found, place, count};
  }
  std::string others() const {
    return count > 1 ? fmt::format("; {} more such {}", count - 1, count == 2 ? "place" : "places") : "";
  }
};

std::string where(const std::vector<SurveyPoint>& points, std::size_t i) {
  return fmt::format("between MD {:.6g} and {:.6g} m", points[i - 1].station.measured_depth,
                     points[i].station.measured_depth);
}

}  // namespace

void require_good(const SurveyRows& rows) {
  for (std::size_t i = 0; i < rows.stations.size(); ++i) {
    require_station(rows, i);
    if (i > 0) require_step(rows, i);
  }
}

std::vector<std::string> doubts(const SurveyRows& rows, const std::vector<SurveyPoint>& points) {
  Worst dogleg, spacing, tvd;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double distance = points[i].station.measured_depth - points[i - 1].station.measured_depth;
    if (points[i].curvature > sharp_dogleg) dogleg.add(points[i].curvature, i);
    if (distance > wide_spacing && points[i].curvature * distance > straight) spacing.add(distance, i);
  }
  const std::size_t added = points.size() - rows.stations.size();
  for (std::size_t i = 0; i < rows.tvd.size(); ++i) {
    const double difference = std::abs(rows.tvd[i] - points[i + added].position.z);  // NaN where the file has none
    if (difference > tvd_tolerance) tvd.add(difference, i);
  }
  std::vector<std::string> found;
  if (dogleg.count > 0) {
    found.push_back(fmt::format("{}: a dogleg of {:.4g} degrees per 30 m {} (few holes turn by more than 30{})",
                                rows.source, dogleg.value * 30.0 / deg, where(points, dogleg.at), dogleg.others()));
  }
  if (spacing.count > 0) {
    found.push_back(
        fmt::format("{}: {:.4g} m between two stations in a curve, {} (beyond 50 m the path between them is "
                    "little known{})",
                    rows.source, spacing.value, where(points, spacing.at), spacing.others()));
  }
  if (tvd.count > 0) {
    found.push_back(fmt::format(
        "{}:{}: TVD {:.7g} m, but {:.7g} m by minimum curvature of the stations (the latter is "
        "used{})",
        rows.source, rows.lines[tvd.at], rows.tvd[tvd.at], points[tvd.at + added].position.z, tvd.others()));
  }
  return found;
}

}  // namespace bitrock::studies
