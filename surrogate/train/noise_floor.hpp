#pragma once
/// How far from the DEM's averages a faultless network would lie, because these averages scatter, and whether a network
/// lies farther off than that. The three cuts of a case give a standard error that is itself wrong by half; the law of
/// scatter (`scatter.hpp`), found over all cases, gives each case a standard error s_i one can build on, so everything
/// here is reckoned with that. Draws no random number.
///
/// **Largest deviation** of n cases whose deviations are independent and normal, N(0, s_i^2):
///
///     P(max |d_i| <= x) = prod erf(x / (sqrt(2) s_i)),   E[max |d_i|] = integral from 0 of 1 - that product over x
///
/// With s_i / y_i in place of s_i: of deviations relative to the DEM mean y_i.
/// **Mean deviation** sqrt(2 / pi) times the mean of s_i.
///
/// **How many times above the noise** k = RMSE / s, s^2 the mean of s_i^2. Where the network is faultless, k^2 follows
/// Fisher's F distribution; its degrees of freedom [Satterthwaite1946; not consulted] say how many equal parts a sum of
/// unequal parts is worth: for the numerator nu_1 = (sum s_i^2)^2 / sum s_i^4 over the cases compared, for the
/// denominator nu_2 = (sum m_i v_i)^2 / sum m_i v_i^2 over all cases of n_i = m_i + 1 cuts, v_i = n_i s_i^2.
/// For a network with a fault, as if the fault scattered like the noise, the same F gives an interval of k.
///
/// **Worst case** The residual r_i of a case is its deviation over the standard error the law gives half-way between
/// DEM mean and prediction: there it is defined for a count of zero too, and nearly normal for small counts. Of n cases
/// of a faultless network, all stay below t with P(|Student's t of nu_2| <= t)^n = 1 - level.
///
/// **Verdict**, the first that holds; a faultless network passes for one with a fault once in twenty data sets, or less
/// often (the level of each of the two tests is 2.5 %)
/// - no scatter known: no case was cut twice, or all cuts of every case are equal.
/// - above the noise: k^2 above the 97.5 % point of F. RMSE is mostly made by the cases of large values.
/// - above it in places: not so, but there are cases of residuals larger than t.
/// - too noisy to tell: the DEM means of all cases vary over the cases no more than chance would have them (their
///   variance / s^2 below the point of F(cases - 1, nu_2)); or k is so uncertain that a network twice as far off as the
///   noise might look the same (upper end of the interval of k above 2).
/// - at the noise floor: otherwise.
///
/// **Validity** On cases the network has learnt from, k may well be below 1, for there it follows the noise; only on
/// others is RMSE^2 = (error of the network)^2 + s^2. The relative deviations divide by y_i, which scatters itself: for
/// s_i / y_i above about 0.2 (a count of a few peaks) chance alone makes larger ones than said here. Verdicts do not
/// suffer from that: their levels hold down to counts of 0.3 to 3 peaks a cut (see the test). Cases are taken
/// as independent, although those of one seed are cut in the same rock.

#include <optional>
#include <span>
#include <vector>

namespace bitrock::surrogate {

/// E[max |d_i|], in the unit of the standard errors; 0 for none.
double expected_largest(std::span<const double> standard_errors);

/// The value that max |d_i| stays below with this probability, above 0 and below 1.
double largest_quantile(std::span<const double> standard_errors, double probability);

/// E[mean |d_i|]; 0 for none.
double expected_mean(std::span<const double> standard_errors);

/// Degrees of freedom of the sum of m_i v_i, each v_i of m_i degrees of freedom. 0 when all v_i are zero.
double effective_degrees(std::span<const double> variances, std::span<const double> degrees);

/// Value that an F-distributed number with these degrees of freedom, both above 0, stays below with this probability.
double f_quantile(double probability, double numerator_degrees, double denominator_degrees);

/// What can be said of a network.
enum class Verdict {
  no_scatter_known,  ///< no case was cut twice, or all cuts of every case are equal
  too_noisy,         ///< to tell a network that is faultless from one that is not
  at_noise_floor,    ///< no fault is seen
  above_in_places,   ///< some cases lie farther off than chance has them
  above_noise_floor  ///< all cases together do
};

/// What the verdict rests on: the cases compared, and the variances of the law.
struct NoiseEvidence {
  double rmse = 0.0;                  ///< over the cases compared
  double noise = 0.0;                 ///< s over the same cases, in the unit of rmse; 0: no scatter known
  double compared_degrees = 0.0;      ///< nu_1
  double law_degrees = 0.0;           ///< nu_2
  int all_cases = 0;                  ///< with which the variance of the DEM means was found
  double variance_of_means = 0.0;     ///< between the DEM means of all cases
  double noise_of_all_squared = 0.0;  ///< s^2 over all cases
  std::vector<double> residuals;      ///< r_i of the cases compared [1]
};

/// Absent where it cannot be said.
struct NoiseVerdict {
  Verdict verdict = Verdict::no_scatter_known;  ///< in one word
  std::optional<double> ratio;                  ///< k [1]
  std::optional<double> ratio_low;              ///< [1] lower end of the 95 % interval of k
  std::optional<double> ratio_high;             ///< [1] upper end
  int cases_above = 0;                          ///< whose residuals are larger than t
  std::optional<double> model_error;            ///< sqrt(max(0, rmse^2 - s^2)), in the unit of rmse
};

/// Networks are called at the noise floor only when one so many times as far off would have been seen.
inline constexpr double ratio_to_be_seen = 2.0;

/// By the equations above.
NoiseVerdict judge(const NoiseEvidence& evidence);

}  // namespace bitrock::surrogate
