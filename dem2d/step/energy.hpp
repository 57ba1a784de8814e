#pragma once
/// The energy ledger: where the work of the boundaries went. Switched on by `World::ledger.measured` before `prepare`;
/// it reads what the step does anyway and changes nothing, so a measured run is bit for bit the same run.
///
/// **Balance.** For any two instants,
///
///     work of boundaries + work of mud + entered + injected =
///         change of (kinetic + strain) + friction + dashpots + local damping + breaking + switching + removed +
///         residual
///
/// Kinetic energy comes from masses and velocities, strain energy from positions and stresses, losses from force times
/// slip or velocity; breaking and switching are found by difference, each within one step of one contact: what a break
/// releases, and **switching**, what the scheme itself gains or loses when a spring closes or opens somewhere within a
/// step. (A spring k that closes at speed v takes k u v dt / 2 from the motion and holds k u^2 / 2, u being the overlap
/// at the end of the step; on average it swallows k (v dt)^2 / 12, and gives as much when it opens at the same speed.
/// Contacts with dashpots open slower than they close, so in a cut it is a small loss, of second order in dt.)
/// The residual checks motion, strain of bonded joints and closed contacts, friction, dashpots, damping and the work of
/// boundaries against each other. It cannot see an error in the strain energy of an element that is partly open,
/// because that cancels against switching: switching must be small by itself (it is tested against k (v dt)^2 / 12).
/// What is left in the residual is rounding, the turning of contacts within a step, and what the half step does at the
/// instant a joint ends or a disc leaves.
///
/// **Leap-frog.** Velocities live half a step from positions, so energies must not simply be added. Over the interval
/// from t to t + dt the discs move by v dt, v = v(t + dt/2), and the scheme gives exactly
///
///     m v(t + dt/2) (v(t + 3dt/2) - v(t - dt/2)) / 2 = (F(t) + F(t + dt))/2 v dt
///
/// so the kinetic energy that belongs to positions at t is m v(t - dt/2) v(t + dt/2) / 2 (a linear spring then keeps
/// its energy to rounding), and the work of any force in the interval is the mean of its two values times the motion.
///
/// Source: derived here; the conserved product of the two velocities is common knowledge about the Verlet scheme.
/// All energies in J per metre of thickness.

#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

struct Energies {
  double kinetic = 0.0;  ///< of all discs, spin included
  /// Elastic: in flat joints; in contacts of loose discs; in contacts of discs with boundaries.
  double strain_joints = 0.0, strain_contacts = 0.0, strain_boundaries = 0.0;
  double friction = 0.0;       ///< of unbonded elements, loose discs and boundaries
  double dashpots = 0.0;       ///< of contacts, between discs and with boundaries
  double local_damping = 0.0;  ///< of all discs, also those that have left
  double breaking = 0.0;       ///< released by elements that broke
  double switching = 0.0;      ///< by springs that close or open within a step, see above
  double removed = 0.0;        ///< with discs that left the domain
  double injected = 0.0;       ///< net, by contacts that took over from joints, and by joints that enter the
                               ///< window of a cut strained
  double entered = 0.0;        ///< elastic, of rock that enters the window of a cut: the mud has pressed it already
  double boundary_work = 0.0;  ///< of all boundaries on the discs
  double mud_work = 0.0;       ///< of the mud on the discs: mostly negative, debris takes more room than rock
};

/// The ledger at this instant. Call between `find_forces` and `move` with `measure_energy` on. Sums run in the order of
/// the lists, so the numbers are the same for any number of threads.
Energies read_energies(const World& world);

/// An entry of the ledger, and what it is called in run files and in Python, with "_J_per_m" behind it.
struct EnergyEntry {
  const char* name;             ///< such as "cutter_work", which is `boundary_work` of a cut
  double Energies::*value;      ///< [J/m]
  const char* meaning;          ///< for people: long_name of its array in run files
  bool only_under_mud = false;  ///< always 0 without mud
};
/// All entries of `Energies`, in the order of run files.
inline constexpr EnergyEntry energy_entries[] = {
    {"cutter_work", &Energies::boundary_work, "work of the cutter so far"},
    {"kinetic", &Energies::kinetic, "of all discs in the domain"},
    {"strain_joints", &Energies::strain_joints, "elastic, in flat joints"},
    {"strain_contacts", &Energies::strain_contacts, "elastic, in contacts of loose discs"},
    {"strain_boundaries", &Energies::strain_boundaries, "elastic, in contacts with cutter and walls"},
    {"friction", &Energies::friction, "lost to friction so far"},
    {"dashpots", &Energies::dashpots, "lost to dashpots so far"},
    {"local_damping", &Energies::local_damping, "lost to local damping so far"},
    {"breaking", &Energies::breaking, "released by elements that broke so far"},
    {"switching", &Energies::switching, "lost by springs that closed or opened within a step so far"},
    {"removed", &Energies::removed, "gone with discs that left the domain so far"},
    {"injected", &Energies::injected, "net, by contacts that took over from joints so far"},
    {"mud_work", &Energies::mud_work, "work of the mud on the rock so far", true},
    {"entered", &Energies::entered, "elastic, of rock that came in under pressure so far", true}};

/// What has come since `start`, entry by entry.
Energies since(const Energies& start, const Energies& now);

/// Work and injected energy since `start` that is found nowhere [J/m].
double energy_residual(const Energies& start, const Energies& now);

/// Residual over the work of the boundaries since `start`; 0 when there was none.
double energy_residual_fraction(const Energies& start, const Energies& now);

/// Injected energy over the work of the boundaries since `start`; 0 when there was none.
double energy_injected_fraction(const Energies& start, const Energies& now);

/// Above this share the forces of a run are not to be trusted [1]. It was 10 to 40 % in stiff rocks while contacts
/// began with the overlap of the packing; it is below 0.1 % since they take over what their joint carried
/// (handover.hpp).
inline constexpr double most_injected = 0.02;

/// Where the faces of a joint and its discs are to each other.
struct JointPosition {
  double gap;       ///< of the faces at their middle [m]
  double rotation;  ///< of disc 2 against disc 1 since installation [rad]
  double overlap;   ///< of the discs, negative when apart [m]
};
/// By the present places of its two discs. `joint` is its place in `FlatJoints`.
JointPosition joint_position(const World& world, std::size_t joint);

/// Elastic energy in a joint [J/m].
double joint_energy(const World& world, std::size_t joint);

/// Elastic energy in all contacts of loose discs [J/m].
double contact_strain(const World& world);

/// Half a step's work of the last force of joint or contact `place` on its two discs [J/m]. What ends between two
/// instants has worked over half a step less than the leap-frog books assume.
double last_half_step(const World& world, const std::vector<PairForce>& forces, std::size_t place, int disc1,
                      int disc2);

/// What leaves the lists hands its losses to `World::ledger.accounts` first: joints, of which `stays` has one flag
/// each, 0 for those that leave. Nothing where energy is not measured.
void book_joint_losses(World& world, const std::vector<char>& stays);
void book_contact_losses(World& world);  ///< of all contacts; theirs start again at 0
/// The same of discs, with the energy in their motion, joints and contacts as `removed`; books the losses of their
/// joints and of all contacts, too. Only where energy is measured.
void book_lost_discs(World& world, const std::vector<char>& discs_stay, const std::vector<char>& joints_stay,
                     const std::vector<char>& contacts_stay);

}  // namespace bitrock::dem2d
