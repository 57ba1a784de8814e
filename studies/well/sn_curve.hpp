#pragma once
/// How many cycles of one stress range a pipe lives: its S-N curve.
///
/// **Equation.** Straight lines in the logarithms, one after the other towards smaller ranges and longer lives,
///
///     log10 N = A - m log10 (S / 1 MPa)      up to N_k cycles; beyond, the next line
///
/// **Symbols.** S [Pa] range of the stress of a cycle, from its least to its largest; N [1] cycles to failure; A, m
/// [1]; N_k [1] where a line ends; the last one goes on without end, or life is endless below the range where it ends.
///
/// **Source.** The form is that of the tables of classification societies; each curve names its own source.

#include <string>
#include <string_view>
#include <vector>

namespace bitrock::studies {

/// One line of the curve.
struct SnLine {
  double log10_a;      ///< A, of ranges in MPa [1]
  double slope;        ///< m [1], above 0
  double most_cycles;  ///< N_k [1]; infinite: it goes on
};

/// From large ranges to small ones.
struct SnCurve {
  std::string name, source;    ///< for people
  std::vector<SnLine> lines;   ///< at least one
  bool endless_below = false;  ///< no damage by ranges below the end of the last line
};

/// Curves that are known by name: "B1 air". Null where there is none of that name.
const SnCurve* find_sn_curve(std::string_view name);

/// The curve through points of range [MPa] and cycles, ranges falling and cycles rising; its first and last lines go
/// on. Throws `base::InputError` beginning with `source` for fewer than two points, and where it does not fall.
SnCurve sn_curve_through(const std::vector<double>& ranges_MPa, const std::vector<double>& cycles,
                         const std::string& name, const std::string& source);

/// N for a range S [Pa], 0 or more; infinite for 0.
double cycles_to_failure(const SnCurve& curve, double range);

}  // namespace bitrock::studies
