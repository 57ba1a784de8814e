#include "runtime/signal/pulse_train.hpp"

#include <algorithm>
#include <tuple>

#include "runtime/signal/step5.hpp"

namespace runtime {

namespace {

/// Makes `active` right for `angle`. Going forward it drops and adds; going back it begins anew.
void follow(PulseTrain& train, double angle) {
  if (angle < train.from) {
    train.active.clear();
    train.next = 0;
  }
  std::erase_if(train.active, [angle](const Pulse& pulse) { return pulse.end <= angle; });
  for (; train.next < train.pulses.size() && train.pulses[train.next].begin < angle; ++train.next) {
    if (train.pulses[train.next].end > angle) train.active.push_back(train.pulses[train.next]);
  }
  train.from = angle;
  train.until = std::numeric_limits<double>::infinity();
  if (train.next < train.pulses.size()) train.until = train.pulses[train.next].begin;
  for (const Pulse& pulse : train.active) train.until = std::min(train.until, pulse.end);
}

/// Force while the active pulses are right for `angle`.
template <Combine combine>
ForcePerMetre active_force(const PulseTrain& train, double angle) {
  ForcePerMetre total;
  for (const Pulse& pulse : train.active) {
    const double distance = angle - pulse.centre;
    const double shape_x = unit_pulse(distance, pulse.inverse_half_width_x);
    const double shape_y = pulse.inverse_half_width_x == pulse.inverse_half_width_y
                               ? shape_x
                               : unit_pulse(distance, pulse.inverse_half_width_y);
    if constexpr (combine == Combine::sum) {
      total.x += pulse.x * shape_x;
      total.y += pulse.y * shape_y;
    } else {
      total.x = std::max(total.x, pulse.x * shape_x);
      total.y = std::max(total.y, pulse.y * shape_y);
    }
  }
  return total;
}

bool remembered(const PulseTrain& train, double angle) {
  return angle >= train.from && angle < train.until;
}

/// One stretch with unchanging active pulses after the other: most have none or one.
template <Combine combine>
void add_all(PulseTrain& train, std::span<const double> angles, double start, const Accumulation& x,
             const Accumulation& y) {
  for (std::size_t i = 0; i < angles.size();) {
    if (!remembered(train, angles[i] - start)) follow(train, angles[i] - start);
    std::size_t end = i + 1;
    while (end < angles.size() && remembered(train, angles[end] - start)) ++end;
    if (train.active.empty()) i = end;
    for (; i < end; ++i) {
      const ForcePerMetre here = active_force<combine>(train, angles[i] - start);
      x.total[i] += x.factor * here.x;
      y.total[i] += y.factor * here.y;
    }
  }
}

}  // namespace

PulseTrain make_pulse_train(std::size_t capacity) {
  PulseTrain train;
  train.pulses.reserve(capacity);
  train.active.reserve(capacity);
  return train;
}

void restart(PulseTrain& train) {
  // pulses that begin together are ordered by all the rest, so that the sequence is unique
  const auto key = [](const Pulse& pulse) { return std::tie(pulse.begin, pulse.centre, pulse.x, pulse.y); };
  std::sort(train.pulses.begin(), train.pulses.end(),
            [key](const Pulse& a, const Pulse& b) { return key(a) < key(b); });
  train.active.clear();
  train.next = 0;
  train.from = 0.0;
  train.until = -std::numeric_limits<double>::infinity();
}

ForcePerMetre force_at(PulseTrain& train, Combine combine, double angle) {
  if (!remembered(train, angle)) follow(train, angle);
  return combine == Combine::sum ? active_force<Combine::sum>(train, angle) : active_force<Combine::max>(train, angle);
}

void add_forces(PulseTrain& train, Combine combine, std::span<const double> angles, double start, Accumulation x,
                Accumulation y) {
  if (combine == Combine::sum) {
    add_all<Combine::sum>(train, angles, start, x, y);
  } else {
    add_all<Combine::max>(train, angles, start, x, y);
  }
}

}  // namespace runtime
