#pragma once
/// Spectra of one quantity laid over each other on logarithmic axes, with upright lines where a peak is expected. It
/// computes no spectrum (base/spectrum.hpp does) and does not know what is expected there.

#include <span>
#include <string>
#include <vector>

#include "base/spectrum.hpp"
#include "report/plot.hpp"

namespace bitrock::report {

struct SpectrumLine {
  std::string name;
  Colour colour = Colour::automatic;
  base::Spectrum spectrum;
  std::vector<double> marks = {};  ///< [Hz] where upright lines are drawn
};

/// What lies this far below the highest value of all is usually rounding, and not drawn. [decades]
inline constexpr double drawn_decades = 9.0;

/// `decades`: drawn below the highest value; a strong line leaves what others are far below it.
/// Frequencies from the lowest above zero to half the fastest rate, densities in whole decades around the data. Values
/// of 0 are left out. Marks that all spectra have in common are drawn once, dashed and grey, as `marks_name`; otherwise
/// each has its own, dashed in its colour. Without data the plot has axes only.
Plot spectrum_plot(std::string title, std::string density_label, const std::string& marks_name,
                   std::span<const SpectrumLine> lines, double decades = drawn_decades);

}  // namespace bitrock::report
