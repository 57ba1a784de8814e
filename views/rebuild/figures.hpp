#pragma once
/// The figures of a rebuilt force beside the DEM's. Numbers come from `studies::rebuild`; here is only which number
/// goes where.

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "studies/rebuild/rebuild.hpp"

namespace bitrock::views {

/// "0.5 mm, 1 m/s, 20 deg".
std::string conditions_in_words(const studies::KnownCase& known);

/// The first cut of a case and as much of a rebuilt force, over the travel, one below the other on one scale. `first`
/// and `length` [m] choose a part.
std::vector<report::Plot> history_plots(const studies::KnownCase& known, const studies::RebuiltForce& rebuilt,
                                        const std::string& way, double first, double length);

/// Octaves over travel and exceedance of both components of one comparison.
std::vector<report::Plot> spectrum_plots(const studies::Portrait& dem, const studies::Portrait& rebuilt);
std::vector<report::Plot> exceedance_plots(const studies::Portrait& dem, const studies::Portrait& rebuilt);

/// Mean, deviation and damage-equivalent range of the rebuilt force against those of the DEM, all cases of one way.
std::vector<report::Plot> parity_plots(const studies::Rebuilding& rebuilding, bool from_model,
                                       runtime::SignalMode mode);

}  // namespace bitrock::views
