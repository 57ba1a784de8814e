#pragma once
/// The upper end of a string at the table: how new pipe comes in, how it hangs, and what turns it.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// **What** New pipe of one step: the uppermost segment becomes longer at its upper end, and gives off a segment where
/// it is long enough (`Growth::split`).
/// **Equation** L += v h; lower end, its velocity V and the angular velocity stay; mass, inertia, centre and the
/// springs at both ends follow L. Work done by that, besides m' g e:
///   [ m' V^2 / 2 - v (H + (H^2 + F^2) / 4EA + (Q^2 + S^2) / 4 kappa GA + (T_d^2 + T^2) / 4GJ + M^2 / 4EI) ] h.
/// **Symbols** v [m/s] feed; m' = mass per metre times v; V [m/s] of the upper end; H [N] hook load, F, S, T, M
/// tension, shear, torque and moment of the joint below; T_d [N m] torque of the drive; e [m] how low the upper end
/// hangs.
/// **Source** derived here, docs/theory/well.md: new pipe enters with the speed of what it joins, so it does not push.
void lengthen_top(const WellString& string, WellStringState& state, const RigControls& controls, double h);

/// **What** Hoist and drive on the uppermost segment, as loads of its upper end.
/// **Equation** H = max(0, k e + c (e' - v)), k = 2 EA / L: a line that only pulls (unless `hoist_pushes`); sideways a
/// spring of 5e7 N/m; T = k_t (Phi - sigma) + c_t (Phi' - sigma'), k_t = 2 GJ / L. A drive that gives way turns by J
/// (W' - W) / h = C (W_s - (W + W') / 2) + k (Phi_s - Phi) - T first, T with the speed W that it had (`DriveControl`);
/// a stiff one has the speed that is asked for. Under a torque of its motor (`gives_torque`) it turns by J (W' - W) / h
/// = T_m - T, J the `drive_inertia`; a block that is pulled (`is_pulled`) goes by m (v' - v) / h = H - w s - P.
/// **Symbols** e [m] depth of the upper end below the point where the hoist's spring is free; Phi [rad] angle of the
/// drive; sigma [rad] turns of the segment, counted beyond one turn; T_m [N m]; P [N] pull of the line less the weight
/// of the block and of the pipe above the table, m [kg] mass of the block; s [m] pipe that it has fed since it is
/// pulled, of the weight w [N/m]: the string becomes heavier by w s and what hangs above the table lighter, so a block
/// in balance stays in balance wherever it is. The pipe above the table has no mass.
void load_table(const WellString& string, WellStringState& state, const RigControls& controls, double h);

/// Least inertia of a drive that gives a torque [kg m^2] with which a step of `h` [s] is stable, with the room that
/// `longest_allowed_step` leaves.
double least_drive_inertia(const WellString& string, double h);
/// Least mass of a block that is pulled [kg], likewise.
double least_block_mass(const WellString& string, double h);

/// Energy in the springs of hoist and drive [J].
double table_energy(const WellString& string, const WellStringState& state);

/// The hoist's springs; those of the drive [N/m], [N m/rad].
struct TableSprings {
  double hoist;     ///< along the string
  double sideways;  ///< of the table, across it
  double drive;     ///< in twist
};
/// For the length that the uppermost segment has now.
TableSprings table_springs(const WellString& string, const WellStringState& state);

}  // namespace bitrock::runtime
