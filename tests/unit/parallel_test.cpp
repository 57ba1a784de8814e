// Independent pieces of work side by side.
#include "base/parallel.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "base/errors.hpp"
#include "base/stop.hpp"

using namespace bitrock;

namespace {

TEST(AvailableCores, AreThoseTheProgramIsBoundTo) {
  cpu_set_t all;
  ASSERT_EQ(::sched_getaffinity(0, sizeof(all), &all), 0);
  EXPECT_EQ(base::available_cores(), CPU_COUNT(&all));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core) {
    if (CPU_ISSET(core, &all)) CPU_SET(core, &one);
  }
  ASSERT_EQ(::sched_setaffinity(0, sizeof(one), &one), 0);
  EXPECT_EQ(base::available_cores(), 1);
  ::sched_setaffinity(0, sizeof(all), &all);
}

TEST(ForEachIndex, CallsEveryIndexOnce) {
  for (const int jobs : {1, 2, 7, 100}) {
    std::vector<std::atomic<int>> calls(50);
    base::for_each_index(50, jobs, [&](int index) { ++calls[static_cast<std::size_t>(index)]; });
    for (const std::atomic<int>& called : calls) EXPECT_EQ(called, 1);
  }
  base::for_each_index(0, 4, [](int) { FAIL() << "there is no index to call"; });
}

TEST(ForEachIndex, RunsAsManyAtATimeAsAsked) {
  // two pieces that each wait for the other can only end when both run at once
  std::atomic<int> arrived{0};
  base::for_each_index(2, 2, [&](int) {
    ++arrived;
    while (arrived < 2) {
    }
  });
  EXPECT_EQ(arrived, 2);
}

TEST(ForEachIndex, ThrowsTheErrorAgainAndBeginsNothingAfterIt) {
  std::atomic<int> calls{0};
  const auto fail_at_three = [&](int index) {
    ++calls;
    if (index == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(base::for_each_index(1000, 1, fail_at_three), std::runtime_error);
  EXPECT_EQ(calls, 4);
}

TEST(ForEachIndex, StopsWhenTheUserAsks) {
  base::stop_requested() = true;
  EXPECT_THROW(base::for_each_index(3, 2, [](int) { FAIL() << "stopped before it began"; }), base::Interrupted);
  base::stop_requested() = false;
}

}  // namespace
