// Independent pieces of work side by side.
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "base/errors.hpp"
#include "base/stop.hpp"

namespace {

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
