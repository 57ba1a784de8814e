#include "runtime/signal/pulse_train.hpp"

#include <algorithm>
#include <tuple>

#include "runtime/signal/step5.hpp"

namespace bitrock::runtime {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

void restart(PulseTrain& train) {
  // pulses that begin together are ordered by all the rest, so that the sequence is unique
  const auto key = [](const Pulse& pulse) { return std::tie(pulse.begin, pulse.centre, pulse.x, pulse.y); };
  std::sort(train.pulses.begin(), train.pulses.end(),
            [key](const Pulse& a, const Pulse& b) { return key(a) < key(b); });
  train.active.clear();
  train.next = 0;
  train.after = infinity;
  train.until = -infinity;
}

void follow(PulseTrain& train, double angle) {
  if (!(angle > train.after)) {
    train.active.clear();
    train.next = 0;
    train.after = -infinity;
  }
  // what has ended leaves, what has begun comes; `after` is the last such change, `until` the next one
  train.until = infinity;
  std::size_t kept = 0;
  const auto sort_in = [&](std::uint16_t place) {
    const double end = train.pulses[place].end;
    if (end <= angle) {
      train.after = std::max(train.after, end);
    } else {
      train.until = std::min(train.until, end);
      train.active[kept++] = place;
    }
  };
  for (const std::uint16_t place : train.active) sort_in(place);
  for (; train.next < train.pulses.size() && train.pulses[train.next].begin < angle; ++train.next) {
    train.after = std::max(train.after, train.pulses[train.next].begin);
    sort_in(static_cast<std::uint16_t>(train.next));
  }
  train.active.count = kept;
  if (train.next < train.pulses.size()) train.until = std::min(train.until, train.pulses[train.next].begin);
}

ForcePerMetre force_at(PulseTrain& train, Combine combine, double angle) {
  if (!remembered(train, angle)) follow(train, angle);
  ForcePerMetre total;
  for (const std::uint16_t place : train.active) {
    const Pulse& pulse = train.pulses[place];
    const double x = pulse.x * unit_pulse(angle - pulse.centre, pulse.inverse_half_width_x);
    const double y = pulse.y * unit_pulse(angle - pulse.centre, pulse.inverse_half_width_y);
    total.x = combine == Combine::sum ? total.x + x : std::max(total.x, x);
    total.y = combine == Combine::sum ? total.y + y : std::max(total.y, y);
  }
  return total;
}

}  // namespace bitrock::runtime
