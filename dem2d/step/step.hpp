#pragma once
/// One step of the engine, as a geologist would tell it. Each of its stages is one function (stages.hpp); the order is
/// the physics.
///
/// Integration is the central-difference (leap-frog) scheme [CundallStrack1979]:
///
///     v(t + dt/2) = v(t - dt/2) + F(t)/m dt          x(t + dt) = x(t) + v(t + dt/2) dt
///
/// and likewise for spin and angle with moment and inertia. Local damping [Cundall1987] takes alpha |F| off every
/// component of the unbalanced force, against the velocity: F <- F - alpha |F| sign(v).

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Advances the world by `world.step`. Allocates nothing but when discs are listed anew.
void advance(World& world);

/// The two halves of `advance`. Between them positions and forces belong to the same instant: the place to look at
/// energies (step/energy.hpp).
void find_forces(World& world);
/// The second half of a step: velocities, positions, boundaries.
void move(World& world);

/// Share of the longest stable step that is taken [ItascaPFC], and the longest allowed; see `critical_step` [1].
inline constexpr double usual_step_factor = 0.8, longest_step_factor = 1.0;

/// Largest stable step [s] times `factor`, over all discs and their present contacts:
///
///     dt = factor min over discs of ( sqrt(m / k_x), sqrt(m / k_y), sqrt(I / k_rot) )
///     k_x = sum (Kn n_x^2 + Ks n_y^2)     k_rot = sum (Ks rho^2 + Kr)
///
/// joint: Kn = kn 2R, Ks = ks 2R, Kr = kn (2/3) R^3, rho = distance from the centre to the interface; contact: Kr = 0.
/// Source: [ItascaPFC, time-step determination] for the form. Margin: the central-difference scheme is stable for
/// omega dt < 2. For kappa >= 1 omega^2 is at most 4 times the larger of k/m and k_rot/I (proof in
/// docs/theory/flat_joint.md, "Stable step"), so omega dt <= 2 factor; in a packing of the article's rock it is 1.0
/// factor. The rest is for contacts that come later, and for dashpots, which lower the limit to 2 (sqrt(1 + zeta^2) -
/// zeta), zeta being the mode's share of critical damping: debris of the article's rock, pressed together without a
/// joint and with half the critical damping in each contact, explodes at a factor of 1.12, and does not at 1.04
/// (tests/verification, `StabilityOfDebris`). Hence the longest factor of 1. With softer normals the margin shrinks; at
/// 0.8 it is gone below kappa = 0.28, at 1 below 1. The step is not checked again during a run.
double critical_step(const World& world, double factor = usual_step_factor);

/// Mean unbalanced force over mean sum of contact forces, over all discs [1]; 0 when nothing touches.
double equilibrium_ratio(const World& world);

/// Throws `SimulationError` with time and disc when a position, velocity or force is not a finite number.
void require_finite(const World& world);

}  // namespace bitrock::dem2d
