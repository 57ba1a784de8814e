#pragma once
/// How a search for micro-parameters ended. Only `reached` is success; the others still name the nearest point found.

namespace bitrock::studies {

enum class SearchEnd {
  reached,       ///< all that is wanted, within tolerance
  out_of_reach,  ///< nothing within the limits of the unknowns comes nearer
  stalled,       ///< several measurements in a row came no nearer
  out_of_budget  ///< as many measurements as allowed were made
};

/// In words, as in JSON: "reached", "out of reach", "stalled", "out of budget".
const char* name_of(SearchEnd end);

}  // namespace bitrock::studies
