#pragma once
/// The chapters of a report about networks: how they learnt, and what they say against what the DEM gave.

#include "report/page.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/parity.hpp"

namespace bitrock::views {

/// Errors over the epochs.
void add_learning_curves(report::Page& page, const surrogate::Model& model);

/// Network against DEM: a verdict for each output, parity and residual plots, all numbers.
void add_parity(report::Page& page, const surrogate::Model& model, const surrogate::Parity& parity);

}  // namespace bitrock::views
