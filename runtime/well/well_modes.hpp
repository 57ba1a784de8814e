#pragma once
/// Natural frequencies of a string in a well: the chain of its segments, along and in twist, as if it hung free of the
/// wall.

#include "runtime/drillstring/drill_case.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// The segments as lumps in a row, from top to bottom, with the springs and dampers of their joints, both ways.
struct WellChains {
  Chain axial;      ///< held at the table by the hoist's spring, or free
  Chain torsional;  ///< below a drive that stands still, or free
};

/// Of the string at its beginning and `added` more pipe [m] at the table, as its growth makes it.
WellChains chains_of(const WellString& string, double added);

/// **What** Natural frequencies of these chains, on the rock's spring where there is rock.
/// **Equation** K x = omega^2 M x with the masses, inertias and springs of the segments and joints: a uniform string of
/// N bars below a table has omega_k = 2 sqrt(K / m) sin((2k - 1) pi / 4N), a free one 2 sqrt(K / m) sin((k - 1) pi /
/// 2N).
/// **Symbols** K of a joint, m of a segment [N/m, kg] / [N m/rad, kg m^2].
/// **Validity** Without wall, friction and mud. Bending has no chain of its own: it depends on where the string lies.
DrillModes modes_of(const WellString& string, double added);

}  // namespace bitrock::runtime
