#pragma once
/// What a computation will cost, for plans and `--check`; no result depends on it.

namespace bitrock::dem2d {

/// What a disc and step take on one core [ns]: cuts of the data set on an EPYC (docs/results/performance.md).
inline constexpr double typical_ns_per_disc_step = 18.0;

/// Seconds of one core for so many steps of so many discs, each disc and step taking `ns` [ns].
constexpr double expected_core_seconds(double steps, double discs, double ns = typical_ns_per_disc_step) {
  return steps * discs * ns * 1e-9;
}

}  // namespace bitrock::dem2d
