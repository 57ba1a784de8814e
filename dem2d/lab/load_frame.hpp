#pragma once
/// The load frame of the laboratory: a core between two platens (ucs, triaxial, brazilian) or held by its two ends
/// (tension, toughness), and what is measured on it. The ends move towards or away from each other at equal and
/// opposite constant speed.
///
/// Platens are flat, rigid boundaries. Discs that overlap a platen at the start do so without force, so the core starts
/// stress-free. Grips hold the discs whose centres lie in the end layers: those have a given velocity and no spin,
/// which they get by being 1e12 times heavier than they are and by being set anew each step.
/// The saw cut of a toughness test is made of joints that were never bonded.
/// The Brazilian disc is cut out of its box: all discs that lie wholly in the inscribed circle.

#include "dem2d/lab/lab_test.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

struct LoadFrame {
  LabTest test;                  ///< that is made
  World world;                   ///< the core and what loads it
  double length = 0.0;           ///< of the core between the ends: platens, or inner ends of the grips [m]
  double section = 0.0;          ///< force over this is the stress [m]
  double end_speed = 0.0;        ///< of each end [m/s]
  double direction = 1.0;        ///< 1: ends part (tension); -1: ends approach
  double travelled = 0.0;        ///< of each end [m]
  double low = 0.0, high = 0.0;  ///< the ends at the start [m]

  // by the number a disc was born with
  std::vector<double> start_x, start_y;  ///< [m]
  std::vector<char> held;                ///< 1 lower grip, 2 upper grip, 0 free
  std::vector<char> measured;            ///< in the middle half

  std::vector<int> held_low, held_high, gauge;  ///< present places of held and of measured discs
};

/// Of the layer that is held at each end of a core that is pulled [m].
double grip_height(double largest_radius, const LabSettings& settings);

/// Discs at rest (brazilian) or straining uniformly (others), prepared, with critical step.
LoadFrame make_load_frame(LabTest test, const Specimen& specimen, const LabSettings& settings);

/// One step of the world with the ends moving on.
void advance(LoadFrame& frame);

/// Forces of the core on its ends along the load, positive as the stress is [N/m].
struct EndForces {
  double low, high;  ///< at the two ends [N/m]
};
/// At this instant.
EndForces end_forces(const LoadFrame& frame);

/// Strain along and across the load now, positive as the stress is [1].
struct CoreStrain {
  double along, across;  ///< [1]
};
/// Of the gauge, since the start.
CoreStrain core_strain(const LoadFrame& frame);

/// Shortening or stretching of the core between its ends over its length [1].
double end_strain(const LoadFrame& frame);

/// At this instant.
LabState state_of(const LoadFrame& frame);

}  // namespace bitrock::dem2d
