#pragma once
/// All that moves, and all that joins it: the state one step of the engine reads and writes. Plain data by component
/// (one array a quantity), so that a loop touches only what it needs.
///
/// Instants: positions and angles live at time t, velocities and spins half a step earlier (t - dt/2), forces at t.
/// Everything is per metre of out-of-plane thickness: masses [kg/m], forces [N/m], moments [N].

#include <array>
#include <cstdint>
#include <vector>

#include "dem2d/contact/flat_joint.hpp"
#include "dem2d/contact/linear_contact.hpp"
#include "dem2d/fluid/mud.hpp"
#include "dem2d/tool/convex_polygon.hpp"

namespace bitrock::dem2d {

/// The discs: one entry each in every array.
struct Discs {
  std::vector<double> x, y, angle;             ///< [m], [m], [rad]
  std::vector<double> velocity_x, velocity_y;  ///< [m/s]
  std::vector<double> spin;                    ///< [rad/s]
  std::vector<double> force_x, force_y;        ///< [N/m]
  std::vector<double> moment;                  ///< [N]
  std::vector<double> radius;                  ///< [m]
  std::vector<double> mass;                    ///< rho pi R^2 [kg/m]
  std::vector<double> inertia;                 ///< mass R^2 / 2 [kg m]
  std::vector<double> inverse_mass;            ///< [m/kg]; 0 for a disc that is held in its place
  std::vector<double> inverse_inertia;         ///< [1/(kg m)]; 0 for a disc that is held in its place
  std::vector<int> id;                         ///< number the disc was born with; keeps its meaning when others leave
  std::vector<double> damping_loss;            ///< to local damping [J/m]; empty unless energy is measured

  int count() const { return static_cast<int>(x.size()); }  ///< discs now in the world
};

/// All arrays of numbers of the discs, for what treats them alike (remove, permute, append); `id` besides.
template <class DiscsType>
auto number_arrays(DiscsType& d) requires requires {
  d.inverse_mass;
}
{
  return std::array{&d.x,    &d.y,       &d.angle,        &d.velocity_x,      &d.velocity_y,
                    &d.spin, &d.force_x, &d.force_y,      &d.moment,          &d.radius,
                    &d.mass, &d.inertia, &d.inverse_mass, &d.inverse_inertia, &d.damping_loss};
}

/// Adds a disc at rest.
void add_disc(Discs& discs, double x, double y, double radius, double density);

/// Sets mass [kg/m] and moment of inertia [kg m], both above 0, and their inverses: a disc that was held moves again.
void set_mass(Discs& discs, std::size_t disc, double mass, double inertia);

/// One entry a joint; `element_shear_stress`, `element_opening` and `state` hold `elements` entries a joint, one after
/// the other.
///
/// A joint is whole while all its elements are bonded and none softens. They have had the same motion then, so they
/// share one shear stress, and the joint goes by its closed form (contact/flat_joint.hpp).
struct FlatJoints {
  int elements = 1;                ///< N_r of every joint [1]
  double residual_cohesion = 0.0;  ///< of elements broken in shear [Pa]
  bool drop_to_residual = false;   ///< shear stress at a shear break: false to zero, true to the residual strength
  double tension_softening = 0.0;  ///< zeta (contact/tension_softening.hpp); set before any joint is added [1]
  std::vector<int> disc1, disc2;   ///< places of the two discs in `Discs`, which change when discs leave
  std::vector<double> half_length, normal_stiffness, shear_stiffness;            ///< [m], [Pa/m], [Pa/m]
  std::vector<double> tensile_strength, cohesion, tan_friction_angle, friction;  ///< [Pa], [Pa], [1], [1]
  std::vector<double> touching_distance;     ///< between centres: the gap of the faces is distance minus this [m]
  std::vector<double> stress_free_rotation;  ///< angle of disc 2 minus angle of disc 1 at installation [rad]
  std::vector<double> radius_difference;     ///< of disc 1 minus disc 2 [m]
  std::vector<double> shear_displacement;    ///< of disc 2 against disc 1, kept up once a joint is damaged [m]
  std::vector<int> bonded;                   ///< elements still bonded, those that soften among them
  std::vector<double> shear_stress;          ///< of a whole joint [Pa]
  std::vector<double> element_shear_stress;  ///< of a damaged joint [Pa]
  std::vector<ElementState> state;           ///< of each element, in whole joints too
  // empty where joints do not soften
  std::vector<int> softened;            ///< bonded elements that soften
  std::vector<double> element_opening;  ///< largest so far over that at the tensile strength; 0 below that [1]
  std::vector<double> friction_loss, switching_loss, breaking_loss;  ///< [J/m]; empty unless energy is measured

  int count() const { return static_cast<int>(disc1.size()); }  ///< joints now on the list
  /// Whether all elements of joint j, 0-based, are bonded and none softens.
  bool whole(std::size_t j) const { return bonded[j] == elements && (softened.empty() || softened[j] == 0); }
  /// Stiffness and strength of joint j, 0-based.
  FlatJointLaw law(std::size_t j) const {
    return {.elements = elements,
            .half_length = half_length[j],
            .normal_stiffness = normal_stiffness[j],
            .shear_stiffness = shear_stiffness[j],
            .tensile_strength = tensile_strength[j],
            .cohesion = cohesion[j],
            .tan_friction_angle = tan_friction_angle[j],
            .friction = friction[j],
            .residual_cohesion = residual_cohesion,
            .drop_to_residual = drop_to_residual,
            .tension_softening = tension_softening};
  }
};

/// All arrays of numbers of the joints with one entry a joint, and all of integers; `element_shear_stress`,
/// `element_opening` and `state`, with `elements` entries a joint, besides.
template <class JointsType>
auto number_arrays(JointsType& j) requires requires {
  j.touching_distance;
}
{
  return std::array{
      &j.half_length,        &j.normal_stiffness, &j.shear_stiffness,   &j.tensile_strength,     &j.cohesion,
      &j.tan_friction_angle, &j.friction,         &j.touching_distance, &j.stress_free_rotation, &j.radius_difference,
      &j.shear_displacement, &j.shear_stress,     &j.friction_loss,     &j.switching_loss,       &j.breaking_loss};
}
/// Those of integers, one entry a joint.
template <class JointsType>
auto integer_arrays(JointsType& j) {
  return std::array{&j.disc1, &j.disc2, &j.bonded, &j.softened};
}

/// What a joint is like when it is made [Potyondy2012].
enum class JointType {
  bonded,  ///< all its elements are
  gapped,  ///< not bonded, faces apart by an initial gap
  slit     ///< not bonded, faces touch
};

/// What `add_joint` needs to know beside the two discs, of radii R1 and R2: half length
/// R = lambda min(R1, R2), kn = E* / (R1 + R2), ks = kn / kappa (docs/theory/flat_joint.md).
struct JointProperties {
  double modulus;                      ///< E* [Pa]
  double stiffness_ratio;              ///< kappa [1]
  double radius_multiplier;            ///< lambda [1]
  double tensile_strength;             ///< [Pa]
  double cohesion;                     ///< [Pa]
  double friction_angle;               ///< [rad]
  double friction;                     ///< [1]
  JointType type = JointType::bonded;  ///< when it is made
  double initial_gap = 0.0;            ///< of a gapped joint [m]
};

/// Pairs of discs near enough to meet before the lists are made anew; sorted by (disc1, disc2), disc1 < disc2.
struct LinearContacts {
  std::vector<int> disc1, disc2;                                 ///< places of the two discs in `Discs`
  std::vector<double> normal_stiffness, dashpot, shear_dashpot;  ///< [Pa], [Pa s], [Pa s]
  std::vector<double> spring;                                    ///< history: force of the shear spring [N/m]
  std::vector<double> reference_overlap;  ///< carries no force: that of a joint this contact took over from [m]
  std::vector<char> touching;             ///< at the last step; if not, the force is zero
  // empty unless energy is measured
  std::vector<double> last_normal_dashpot, last_shear_dashpot;      ///< forces at the last step [N/m]
  std::vector<double> friction_loss, dashpot_loss, switching_loss;  ///< [J/m]

  int count() const { return static_cast<int>(disc1.size()); }  ///< pairs on the list, touching or not
};

/// A rigid polygon that moves at a given velocity: cutter, platen, side of the packing box.
struct Boundary {
  ConvexPolygon shape;                        ///< where it is now: each step moves it
  double velocity_x = 0.0, velocity_y = 0.0;  ///< [m/s]
  double modulus = 0.0;                       ///< E* [Pa]
  double stiffness_ratio = 1.0;               ///< kappa [1]
  double friction = 0.0;                      ///< mu [1]
  double damping_ratio = 0.0;                 ///< beta [1]
  double shear_damping_ratio = 0.0;           ///< beta_s [1]
  bool seals = false;                         ///< whether it keeps mud from the discs that touch it

  double force_x = 0.0, force_y = 0.0;    ///< of the discs on the boundary at the last step [N/m]
  double mud_x = 0.0, mud_y = 0.0;        ///< of the mud, which presses on all of it but where it seals [N/m]
  double moved_x = 0.0, moved_y = 0.0;    ///< in the last step [m]
  double displaced = 0.0;                 ///< path since the neighbour lists were made [m]
  std::vector<int> near;                  ///< discs that can touch before the lists are made anew
  std::vector<double> spring;             ///< history: force of the shear spring, one entry a disc [N/m]
  std::vector<double> reference_overlap;  ///< overlap at the start that carries no force, one entry a disc [m]
  std::vector<double> contact_force_x, contact_force_y, contact_moment;  ///< on the discs of `near`

  // only while energy is measured
  double work = 0.0;                                            ///< done on the discs so far [J/m]
  std::vector<double> last_normal_dashpot, last_shear_dashpot;  ///< one entry a disc [N/m]
};

/// One element that broke.
struct Crack {
  double time;          ///< [s]
  double x, y;          ///< middle of the interface [m]
  double normal_angle;  ///< of the interface normal, from x [rad]
  double length;        ///< of the element [m]
  ElementState mode;    ///< broken in tension or in shear
  int disc1, disc2;     ///< ids of the two discs
};

/// Discs that leave this box are removed [m].
struct Domain {
  double x_low, y_low, x_high, y_high;  ///< a disc leaves when its centre is beyond one of them
};

/// How a disc is placed and moves, side by side: what a joint reads of a disc that lies elsewhere in memory is then
/// three loads of one or two cache lines instead of six of each.
struct alignas(16) MotionRow {
  double x, y;                    ///< [m]
  double velocity_x, velocity_y;  ///< [m/s]
  double angle, spin;             ///< [rad], [rad/s]
};

/// What a contact does to its two discs. Four numbers, one load of a vector unit.
struct alignas(32) PairForce {
  double x, y;              ///< on disc 1, and with the other sign on disc 2 [N/m]
  double moment1, moment2;  ///< on disc 1, on disc 2 [N]
};

/// For each disc the joints to add up, without branches: eight places a disc, four for joints whose disc 1 it is and
/// four for those whose disc 2 it is. Places that are not needed point to a force that is always zero, behind the last
/// joint; joints that find no place stand in `more`, sorted by disc. The order of the sum never depends on threads.
struct JointsOfDiscs {
  /// Of a disc: as disc 1 or as disc 2; in all.
  static constexpr std::size_t places_each = 4, places = 2 * places_each;
  std::vector<int> joint;  ///< `places` entries a disc, those as disc 1 first

  /// A joint that found no place at one of its discs.
  struct Entry {
    int disc, joint;  ///< places in `Discs` and `FlatJoints`
    bool as_disc1;    ///< whether the disc is disc 1 of the joint
  };
  std::vector<Entry> more;  ///< sorted by disc
};

/// Where energy went that no longer is in motion or springs, summed over all that has left the lists and over boundary
/// contacts [J/m]. Discs, joints and contacts on the lists hold their own losses (step/energy.hpp adds them up).
struct EnergyAccounts {
  double friction = 0.0;       ///< lost by faces and discs that slid
  double dashpots = 0.0;       ///< lost in the dashpots of contacts
  double switching = 0.0;      ///< lost by springs that closed or opened within a step; negative: gained
  double local_damping = 0.0;  ///< lost to local damping
  double breaking = 0.0;       ///< released by elements when they broke
  double removed = 0.0;        ///< kinetic and elastic energy of discs that left the domain
  double injected = 0.0;       ///< net, by contacts that took over from joints, and by joints that enter strained
  double entered = 0.0;        ///< elastic, of rock that enters the window of a cut as strained as the bed is
};

/// What does not change while discs move.
struct Materials {
  // linear contacts between discs
  double contact_modulus = 0.0;              ///< E* [Pa]
  double contact_stiffness_ratio = 1.0;      ///< kappa [1]
  double contact_friction = 0.0;             ///< [1]
  double contact_damping_ratio = 0.0;        ///< [1]
  double contact_shear_damping_ratio = 0.0;  ///< [1]

  double local_damping = 0.0;  ///< alpha [1]
};

/// Who can meet whom, and how long that holds (step/neighbours.hpp).
struct NeighbourLists {
  bool valid = false;                      ///< false: everybody is listed anew before the next forces
  long long version = 0;                   ///< counts how often they were made anew: numbers of discs may have changed
  double skin = 0.0;                       ///< lists hold every pair closer than this [m]
  std::vector<double> most_strayed;        ///< largest (moved^2 - margin^2) of any disc, one entry a thread [m2]
  std::vector<double> listed_x, listed_y;  ///< position of each disc when it was last listed [m]
  std::vector<double> listed_margin;       ///< how far it may move from there before it is listed anew [m]
  JointsOfDiscs joints_of_discs;           ///< made anew when joints or discs have left
};

/// Room in which one step hands over from stage to stage; it means nothing between steps.
struct StepRoom {
  std::vector<MotionRow> motion;                 ///< one a disc, copied from the discs at the beginning of each step
  std::vector<PairForce> joint_forces;           ///< one a joint, and behind them one that is zero
  std::vector<PairForce> contact_forces;         ///< one a contact
  std::vector<std::vector<Crack>> fresh_cracks;  ///< of this step, one list a thread
  std::vector<std::vector<int>> slow_joints;     ///< those not done by their closed form, one list a thread
};

/// Energy, where it is asked for (step/energy.hpp).
struct Ledger {
  bool measured = false;    ///< set before `prepare`; changes no force and no motion
  EnergyAccounts accounts;  ///< of what is no longer on the lists; means nothing where it is not measured
};

/// All of it: what moves, what joins it, what surrounds it, and the room a step works in.
struct World {
  // the state
  Discs discs;                       ///< in the order that suits the memory, not that of their ids
  FlatJoints joints;                 ///< bonded or broken; those that are over have become contacts
  LinearContacts contacts;           ///< of discs without a joint between them
  std::vector<Boundary> boundaries;  ///< of a cut: the cutter alone, number 0
  std::vector<Crack> cracks;         ///< in the order of time
  double time = 0.0;                 ///< [s]
  int removed_discs = 0;             ///< so far: beyond the domain, or left behind by the window of a cut

  Domain domain{};              ///< where discs may be
  double step = 0.0;            ///< dt [s]
  int threads = 1;              ///< of a step, 1 or more; results do not depend on it
  bool reference_path = false;  ///< every joint element by element, also the wholly bonded ones

  Materials materials;   ///< of loose discs that meet, and of the local damping
  Mud mud;               ///< none where its pressure is 0
  NeighbourLists lists;  ///< made by `prepare`, kept up by each step
  StepRoom room;         ///< of this step
  Ledger ledger;         ///< where energy went, if it is measured
};

/// Joins two discs at their present distance and angles, stress-free. Before `prepare`.
void add_joint(World& world, int disc1, int disc2, const JointProperties& properties);

}  // namespace bitrock::dem2d
