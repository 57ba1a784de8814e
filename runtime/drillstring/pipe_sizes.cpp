#include "runtime/drillstring/pipe_sizes.hpp"

#include <algorithm>
#include <array>

#include "base/units.hpp"

namespace bitrock::runtime {

namespace {

using base::inch, base::lb_per_ft;

// DP     wall 0.362 and 0.361 in, tool joints NC50 (6.625 x 3.25 in) and HT55 (7.125 x 3.875 in), range 2, and with
// them
//        23.52 and 26.51 lb/ft: data sheets of Workstrings International, "Drill pipe performance characteristics",
//        2011, 5.000 in 19.50 ppf and 5.500 in 21.90 ppf. With other tool joints the mass is another one.
// HWDP   recalled as usual (NC50), not verified by a data sheet; the centre upset counts in the mass alone.
// DC     bars with a bore, sizes recalled of the API's list, not verified; the mass is that of the body.
constexpr std::array sizes{
    PipeSize{"DP 5 19.5", 5.0 * inch, 4.276 * inch, 6.625 * inch, 23.52 * lb_per_ft},
    PipeSize{"DP 5.5 21.9", 5.5 * inch, 4.778 * inch, 7.125 * inch, 26.51 * lb_per_ft},
    PipeSize{"HWDP 5", 5.0 * inch, 3.0 * inch, 6.5 * inch, 49.3 * lb_per_ft},
    PipeSize{"DC 6.5", 6.5 * inch, 2.8125 * inch, 6.5 * inch, 0.0},
    PipeSize{"DC 8", 8.0 * inch, 2.8125 * inch, 8.0 * inch, 0.0},
    PipeSize{"DC 9.5", 9.5 * inch, 3.0 * inch, 9.5 * inch, 0.0},
};

}  // namespace

std::span<const PipeSize> pipe_sizes() {
  return sizes;
}

const PipeSize* find_pipe_size(std::string_view name) {
  const auto* const found =
      std::find_if(sizes.begin(), sizes.end(), [name](const PipeSize& size) { return size.name == name; });
  return found == sizes.end() ? nullptr : found;
}

}  // namespace bitrock::runtime
