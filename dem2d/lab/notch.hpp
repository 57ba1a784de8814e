#pragma once
/// The mode-I toughness of a core with a saw cut through its middle, pulled apart by its ends.
///
/// **Equation.** A plate of width W under the stress s has a through cut of length 2 a in its middle, across the load.
/// At the ends of the cut the stress is s_y = K / sqrt(2 pi r), with the stress intensity factor
///
///     K = s sqrt(pi a) sqrt(sec(pi b / 2)) (1 - 0.025 b^2 + 0.06 b^4)      b = 2 a / W
///
/// and the toughness K_Ic is K at the largest stress that the core carries.
///
/// **Symbols.** s [Pa] force over the whole width; a, W, r [m]; K, K_Ic [Pa sqrt(m)]; b [1].
///
/// **Source.** [TadaParisIrwin2000], the centre-cracked strip; within 0.1 % for any b below 1.
///
/// **Validity.** Held ends do not turn, and neither does a plate with its cut in the middle. The formula is for a long
/// plate; ends one width away from the cut or more change little. The cut is as sharp as grains allow: its tips are
/// known to about half a grain, so a must be several grains, and so must what is left of the width. Rock of one
/// toughness gives the same K_Ic for every a; where the cut is a few grains long, K_Ic comes out small, because the
/// core then breaks by its strength.

#include "dem2d/specimen/specimen.hpp"

namespace bitrock::dem2d {

/// K [Pa sqrt(m)] of a strip of this width [m] with a cut of this length, 2 a [m], in its middle, under this stress
/// [Pa] away from it.
double stress_intensity(double stress, double notch_length, double width);

/// Where a saw cuts: horizontally, through the middle of the specimen's box, so long [m].
struct Notch {
  double x_low, x_high, y;  ///< [m]
};
/// Of this length [m].
Notch middle_notch(const Specimen& specimen, double notch_length);

/// Whether the saw parts two discs whose centres are at these places [m].
bool parts(const Notch& notch, double x1, double y1, double x2, double y2);

}  // namespace bitrock::dem2d
