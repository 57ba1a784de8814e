#pragma once
/// How much more a pipe bends than its hole, because only its tool joints lie on the wall.
///
/// **What.** Pipe that is pulled into a curved hole is straight between its tool joints and sharply bent at them; pipe
/// that is pushed bows out between them. Segments of the model that are as long as a joint of pipe give the mean of
/// that, the curvature of the hole: stress and damage want the largest one.
///
/// **Equation.** B = largest curvature / kappa. Pull, with u = K L and the sag that the pipe lacks of the hole's:
///
///     free        kappa L^2 (1/2 - tanh(u/2)/u) <= g       B = u / tanh u
///     lies on     sqrt(g T / (2 kappa EI)) <= (u/2) / tanh(u/2) - 1     B = 1 + sqrt(2 g T / (kappa EI))
///     touches     between the two: its middle is on the wall
///                 B = (u sinh u - u^2 cosh u + u^2 (1/2 - g / (kappa L^2)) (cosh u - 1)) / (2 (cosh u - 1) - u sinh u)
///
/// Push: B = u / sin u in the middle, until its body touches there, kappa L^2 (tan(u/2)/u - 1/2) = g; beyond, as then.
///
/// **Symbols.** T [N] effective tension, K = sqrt(|T| / EI); EI [N m2] bending stiffness; kappa [1/m] curvature of the
/// hole; L [m] half the distance of the tool joints; g [m] how far they stand out of the body.
///
/// **Source.** derived here: the beam-column T y'' = EI y'''' with the slope of the hole at the tool joints, on a wall
/// that the body may not enter; where it lies on it, curvature and slope are those of the hole up to the free rest. The
/// free pipe is known from [Lubinski1961], the three cases from [PaslayCernocky1991].
///
/// **Validity.** Constant curvature, tool joints on one side of the hole, small slopes. A pipe without tool joints that
/// stand out bends as its hole does, B = 1. Pushed pipe that touches is held at what it had then: not derived beyond.

namespace bitrock::studies {

/// The pipe between two of its tool joints.
struct BetweenToolJoints {
  double bending_stiffness = 0.0;  ///< E I [N m2], above 0
  double half_distance = 0.0;      ///< L [m]; 0: no tool joints
  double stand_off = 0.0;          ///< g [m], 0 or more; infinite: the body never touches
};

/// B [1], 1 or more. Tension [N] effective, below 0 pushed; curvature [1/m] of the hole, 0 or more.
double bending_magnification(const BetweenToolJoints& pipe, double tension, double curvature);

}  // namespace bitrock::studies
