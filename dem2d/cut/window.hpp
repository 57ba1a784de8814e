#pragma once
/// The part of a long bed that moves: rock far ahead of the cutter, and far behind it, stands still anyway, so only the
/// neighbourhood of the cutter is in the world. Rock enters ahead, column by column, as it was made: at rest and free
/// of stress. Rock that falls behind leaves. The outermost columns of both ends that are still in their places are
/// held, so that the rock in between is supported as by the bed it belongs to.
///
/// What this neglects is the elastic motion of the rock beyond, and the waves that would run there and be scattered
/// back; docs/results/validation.md has the forces for several widths, and for the whole bed.

#include "dem2d/cut/cut_case.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// How long the moving part of the bed of a cut is, at most [m].
double moving_length(const CutCase& cut);

struct Window {
  World bed;                                          ///< all of the rock as it was made, its discs in columns
  std::vector<int> place_in_bed;                      ///< of a disc, by its id
  std::vector<std::size_t> joint_order;               ///< joints of `bed` by their second, higher disc
  std::size_t entered_discs = 0, entered_joints = 0;  ///< since the beginning
  double column = 0.0;                                ///< width of a column [m]
  double ahead = 0.0, behind = 0.0;                   ///< of the tip [m]
  double low = 0.0, high = 0.0;                       ///< ends of the window [m]
  Discs left_behind;                                  ///< as they were when the window left them
};

/// Fixes a disc in its place: no force moves what is held. Returns the kinetic energy it had [J/m].
double hold(Discs& discs, std::size_t disc);
/// Gives a held disc its mass back.
void release(Discs& discs, std::size_t disc);

/// Whether a disc has moved less than half its radius from where it was made.
bool is_in_its_place(const Window& window, const Discs& discs, std::size_t disc);

/// Takes the rock beyond `moving_ahead` of the tip out of `world`, which is prepared and in columns.
Window open_window(World& world, const CutCase& cut, double tip_x);

/// What keeps rock from entering, within two columns of the end it comes in at.
enum class AtTheDoor {
  nothing,        ///< rock in its place
  debris,         ///< rock of elsewhere, which lies or flies there
  displaced_rock  ///< rock that was made there and is out of its place: new rock would be laid over it
};
/// The worst of what is there.
AtTheDoor at_the_door(const Window& window, const Discs& discs);

/// Moves the window on when the tip has travelled a few columns. Between two steps.
void advance_window(Window& window, World& world, double tip_x);

}  // namespace bitrock::dem2d
