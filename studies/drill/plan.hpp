#pragma once
/// What is known of a drill string and of a run of it before it runs.

#include <optional>

#include "runtime/drillstring/closed_forms.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/drillstring/steadiness.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::studies {

/// What follows from the parts of the string alone.
struct StringOutlook {
  runtime::DrillModes modes;                  ///< natural frequencies
  std::optional<runtime::ClosedForms> forms;  ///< of the pipe alone; none for a string of several
  std::optional<runtime::Steadiness> steady;  ///< as it is driven; none where that is not known
  runtime::DriveControl control;              ///< of a top drive that gives way; without inertia: a stiff one
  double longest_stable_step = 0.0;           ///< [s]
};
/// `string` is `drill` assembled.
StringOutlook outlook(const runtime::DrillCase& drill, const runtime::DrillString& string);

/// The same of a string in a well, which grows.
struct WellOutlook {
  runtime::DrillModes beginning;     ///< natural frequencies of the string as it begins
  runtime::DrillModes drilling;      ///< with the pipe of the trip
  runtime::DriveControl control;     ///< of a top drive that gives way; without inertia: a stiff one
  double longest_stable_step = 0.0;  ///< [s]
};
/// `string` is `well` assembled.
WellOutlook outlook(const runtime::WellCase& well, const runtime::WellString& string);

/// What a run will be.
struct DrillPlan {
  double static_weight = 0.0;        ///< on the bit [N]
  double step = 0.0;                 ///< that is run [s]
  double longest_stable_step = 0.0;  ///< [s]
  double steps = 0.0;                ///< in all
};
/// `string` is `drill` assembled.
DrillPlan plan(const runtime::DrillCase& drill, const runtime::DrillString& string);

}  // namespace bitrock::studies
