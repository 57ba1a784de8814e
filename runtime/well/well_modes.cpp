#include "runtime/well/well_modes.hpp"

#include <cmath>

#include "runtime/drillstring/modes.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::runtime {

namespace {

/// The string with `added` metres of pipe on top, without a load in it.
WellStringState longer(WellString& string, double added) {
  StringSection& top = string.sections.front();
  const double bar = top.length / top.segments;
  const bool split = string.growth == Growth::split && string.upper_end == UpperEnd::table;
  // whole bars, as long as the top has less than two of them
  const int whole = split ? static_cast<int>(std::floor(added / bar * (1.0 + 1e-12))) : 0;
  top.segments += whole;
  top.length += whole * bar;
  WellStringState state = unloaded(string, {}, rotation_to({0.0, 0.0, 1.0}));
  const std::size_t last = state.count - 1;
  state.top.length += added - whole * bar;
  set_segment(string, state.columns, last, state.top.length);
  if (last > 0) set_joint(string, state.columns, last - 1, false);
  return state;
}

void add_lump(Chain& chain, double inertia, double stiffness, double damping) {
  chain.inertia.push_back(inertia);
  chain.stiffness.push_back(stiffness);
  chain.damping.push_back(damping);
  chain.wall_damping.push_back(0.0);
}

}  // namespace

WellChains chains_of(const WellString& string, double added) {
  WellString copy = string;
  copy.hole.clear();
  copy.guided = copy.on_rock = false;
  copy.longest_grown = 0.0;
  const WellStringState state = longer(copy, added);
  const Columns& columns = state.columns;
  TableSprings table{};
  if (string.upper_end == UpperEnd::table) table = table_springs(copy, state);
  WellChains chains;
  for (std::size_t i = state.count; i-- > 0;) {
    const bool top = i + 1 == state.count && string.upper_end != UpperEnd::clamped;
    const auto spring = [&](double of_table, Column of_joint) { return top ? of_table : columns.at(of_joint, i); };
    const double axial = spring(table.hoist, axial_stiffness), twist = spring(table.drive, torsion_stiffness);
    add_lump(chains.axial, 1.0 / (columns.at(inverse_mass, i) + columns.at(inverse_mass_along, i)), axial,
             string.damping.axial * axial);
    add_lump(chains.torsional, 1.0 / (columns.at(inverse_inertia, i) + columns.at(inverse_inertia_along, i)), twist,
             string.damping.torsion * twist);
  }
  return chains;
}

DrillModes modes_of(const WellString& string, double added) {
  const WellChains chains = chains_of(string, added);
  DrillModes modes{.axial_off_bottom = natural_frequencies(chains.axial),
                   .torsional = natural_frequencies(chains.torsional)};
  if (string.on_rock) modes.axial = natural_frequencies(chains.axial, {.stiffness = string.bit.contact.stiffness});
  return modes;
}

}  // namespace bitrock::runtime
