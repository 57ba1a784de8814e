#pragma once
/// How fast a laboratory test is driven when the user does not say. A real test takes minutes, 1e8 times longer than
/// can be computed; what counts is that the stress is the same everywhere in the core while it grows. So the rate is
/// chosen such that a longitudinal wave crosses the core a given number of times until the expected strength is
/// reached, and "slow" means the same for soft and stiff, weak and strong rock:
///
///     strain rate = expected strength / (transits * length * sqrt(E rho))
///
/// (brazilian: five times that, because the disc shortens by about five times strength / E until it splits; no test is
/// expected to strain more than 0.2.) A core of the article's rock is loaded at about 4 /s in compression, where the
/// reference examples of bonded-particle codes use 0.05 to 1 /s.
///
/// **Symbols.** expected strength [Pa] from the strengths of the joints (below); E [Pa] taken as E* of the joints; rho
/// [kg/m3] as the density of a grain; length [m] of the core along the load.
///
/// **Source.** Own; the numbers of transits are from measurement: halving the rate must change the mean strength by
/// less than 3 % (`bitrock lab --rate-check`; figures and their errors in docs/results/validation.md, "Loading rate").
///
/// **Local damping** is part of the rock, not only of the test: it takes off the energy by which one crack opens the
/// next (docs/decisions/0006). The default is that of a cut, so that the rock that is calibrated is the rock that is
/// cut.
///
/// **Validity.** The expected strengths were within a third of those measured for cohesion / tensile strength of the
/// joints from 2.5 to 20, at a friction of 0.577, joints of equal strength. Other rocks: look with `--rate-check`.

#include "dem2d/lab/lab_test.hpp"

namespace bitrock::dem2d {

/// Rough strength [Pa] from the joints' strengths, above the confining pressure [Pa]: only to choose rates and limits.
double expected_strength(LabTest test, const Rock& rock, double confining_pressure = 0.0);

/// [1/s] Of a triaxial test that of the same core without pressure, so that a series has one rate.
double default_strain_rate(LabTest test, const Rock& rock, const LabSettings& settings);

/// Strain between the ends at the expected strength [1].
double expected_strain(LabTest test, const Rock& rock, double confining_pressure = 0.0);

/// Roughly the critical step, of a disc between four neighbours of its size [s]: only for limits and estimates; that of
/// a packed core is found when it is made.
double expected_step(const Rock& rock);

}  // namespace bitrock::dem2d
