#pragma once
/// A map of a drilling case as a picture: how severe stick-slip is, over speed and hook load.

#include "report/heat_map.hpp"
#include "studies/drill/drill_map.hpp"

namespace bitrock::views {

/// Severity over the speed of the top drive [rpm] and the hook load [kN], with the limit of steady rotation and the
/// case itself. A map of at least two hook loads and two speeds.
report::HeatMap drill_map_picture(const studies::DrillMap& map, const std::vector<studies::MapPoint>& points);

}  // namespace bitrock::views
