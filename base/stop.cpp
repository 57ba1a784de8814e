#include "base/stop.hpp"

#include "base/errors.hpp"

namespace bitrock::base {

std::atomic<bool>& stop_requested() {
  static std::atomic<bool> flag{false};
  return flag;
}

void throw_if_stopped() {
  if (stop_requested().load(std::memory_order_relaxed)) throw Interrupted("stopped by the user");
}

namespace {

std::atomic<int>& savers() {
  static std::atomic<int> count{0};
  return count;
}

}  // namespace

Saving::Saving() {
  ++savers();
}

Saving::~Saving() {
  --savers();
}

bool is_saving() {
  return savers() > 0;
}

}  // namespace bitrock::base
