#pragma once
/// The chapter of a report about rebuilt forces: a shallow and a deep cut beside what is rebuilt of them, and how near
/// all cases come.

#include "report/page.hpp"
#include "studies/rebuild/rebuild.hpp"

namespace bitrock::views {

/// `model` as it was given to `studies::rebuild`, or null.
void add_rebuild(report::Page& page, const studies::Rebuilding& rebuilding, const surrogate::Model* model,
                 const studies::RebuildOptions& options);

}  // namespace bitrock::views
