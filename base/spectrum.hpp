#pragma once
/// How the variance of an evenly sampled signal is spread over frequencies.

#include <cstddef>
#include <span>
#include <vector>

namespace bitrock::base {

/// Power over frequency.
struct Spectrum {
  std::vector<double> frequency;    ///< [Hz] 0, rate / L, 2 rate / L, ... up to half the rate
  std::vector<double> density;      ///< [X^2/Hz] X the unit of the signal; one-sided
  int segments = 0;                 ///< K
  double relative_deviation = 0.0;  ///< [1] standard deviation of one value over its mean, for Gaussian noise
};

/// Fewer samples than this have no spectrum worth the name; `welch` then gives an empty one.
inline constexpr std::size_t least_segment = 4;

/// **What** One-sided power spectral density by averaging over half-overlapping segments.
/// **Equation** P_j = s_j / (f_s K sum_n w_n^2) sum_k |sum_n w_n (x_{n + k h} - m) exp(-2 pi i j n / L)|^2,
/// w_n = sin^2(pi n / L), h = floor(L / 2), K = 1 + floor((N - L) / h); s_j = 1 at zero and at half the rate, otherwise
/// 2. Scatter of one value: sqrt([1 + 2 rho (K - 1) / K] / K), rho = (sum_n w_n w_{n+h} / sum_n w_n^2)^2.
/// **Symbols** x [X] the signal of N samples, m its mean; f_s [Hz] rate; L samples in a segment; w [1] Hann window;
/// P [X^2/Hz] at j f_s / L.
/// **Source** [Welch1967], with the window of Hann; the transform is Eigen's (kissfft).
/// **Differences and validity** The mean of the whole signal is taken out, not that of each segment, so slow drift
/// stays visible near zero. sum_j P_j f_s / L is the mean over the segments of the variance under w^2: the variance of
/// the signal where it is steady. Lines closer than 2 f_s / L are not told apart. A `segment` longer than the signal is
/// cut to it. Throws `InputError` for values that are not finite, a rate that is not positive, a segment below
/// `least_segment`.
Spectrum welch(std::span<const double> signal, double rate, std::size_t segment);

/// The largest number up to `most` without other factors than 2, 3 and 5: lengths that are quick to transform, while a
/// large prime would take time with its square. At least 1.
std::size_t quick_length(std::size_t most);

/// Frequency of the highest value above zero frequency [Hz]; 0 where all is 0 or there is none.
double strongest_frequency(const Spectrum& spectrum);

}  // namespace bitrock::base
