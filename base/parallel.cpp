#include "base/parallel.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <numeric>
#include <system_error>
#include <thread>
#include <vector>

#include "base/stop.hpp"

namespace bitrock::base {

int available_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (::sched_getaffinity(0, sizeof(cores), &cores) == 0) return std::max(1, CPU_COUNT(&cores));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // a machine of more than 1024 cores
}

void for_each_index(int count, int jobs, const std::function<void(int)>& function) {
  std::atomic<int> next{0};
  std::atomic<bool> broken{false};
  std::mutex mutex;
  std::exception_ptr first;
  int index_of_first = count;

  const auto work = [&] {
    while (!broken) {
      const int mine = next++;
      if (mine >= count) return;
      try {
        throw_if_stopped();
        function(mine);
      } catch (...) {
        const std::lock_guard lock(mutex);
        broken = true;
        if (mine < index_of_first) {
          index_of_first = mine;
          first = std::current_exception();
        }
      }
    }
  };
  std::vector<std::jthread> helpers;  // they join when they go out of scope, whatever happens
  try {
    for (int helper = 1; helper < std::min(jobs, count); ++helper) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // no more threads to be had: those there are do the work
  }
  work();
  helpers.clear();
  if (first) std::rethrow_exception(first);
}

void SharedProgress::set(std::size_t piece, double share) {
  const std::lock_guard lock(mutex_);
  done_[piece] = share;
  if (listener_) listener_(std::accumulate(done_.begin(), done_.end(), 0.0), static_cast<double>(done_.size()));
}

}  // namespace bitrock::base
