#pragma once
/// How much single cuts of one case scatter: a law of one number an output, found over all cases together. The two or
/// three cuts of one case say little about their own scatter; all cases together say much about the common law. It
/// weighs errors in training and says how large a deviation the noise of the data alone would make.
///
/// **Equation** var(y) = phi y^2 for amplitudes and all that is no count (the rock changes all forces by a share of
/// them), var(y) = phi y / L for peaks per metre (peaks come one by one; phi = 1 if they came independently of each
/// other). Over all cases i with n_i cuts, mean y_i and standard error s_i of that mean:
///
///     phi = sum (n_i - 1) n_i s_i^2 / sum (n_i - 1) g_i,   g_i = y_i^2 or y_i / L_i
///
/// **Symbols** y [N/m] or [1/m], L length of cut [m], phi [1].
/// **Source** overdispersion estimated from the pooled Pearson statistic [McCullaghNelder1989].
/// **Validity** cases of two cuts or more; `docs/results/validation.md` compares the laws with the scatter seen.

#include <array>
#include <span>

#include "surrogate/train/data.hpp"

namespace bitrock::surrogate {

struct ScatterLaw {
  OutputValues phi{};           ///< [1], of a single cut
  int degrees_of_freedom = 0;   ///< sum of n_i - 1, or what a formula leaves; 0: nothing is known
  bool around_formula = false;  ///< found from single cuts around a smooth formula (`smooth_formula.hpp`) instead
};

/// `means`: one row a case, as from `averaged`.
ScatterLaw scatter_law(std::span<const TrainingRow> means);

/// Standard error by the law [unit of the output] of the mean over `cuts` cuts of length `cut_length` [m] whose true
/// value is `value`.
double standard_error(const ScatterLaw& law, std::size_t output, double value, double cut_length, int cuts);

}  // namespace bitrock::surrogate
