#pragma once
/// The chapters of a report about networks: how they learnt, and what they say against what the DEM gave.

#include <string>

#include "report/page.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/parity.hpp"

namespace bitrock::views {

/// Errors over the epochs.
void add_learning_curves(report::Page& page, const surrogate::Model& model);

/// Network against DEM: a verdict for each output, parity and residual plots, all numbers. The headings begin with
/// `part_of`, where a page shows more than one comparison.
void add_parity(report::Page& page, const surrogate::Model& model, const surrogate::Parity& parity,
                const std::string& part_of = "");

}  // namespace bitrock::views
