// A program outside the house that uses the engine and the peaks, and links the runtime.
#include <cstdio>
#include <vector>

#include "dem2d/cut/run_cut.hpp"
#include "peaks/statistics.hpp"

using namespace bitrock;

int main() {
  dem2d::CutCase cut;
  cut.cutter_speed = 1.0;        // m/s
  cut.cut_length = 0.01;         // m
  cut.sampling_distance = 1e-5;  // m
  const dem2d::CutSchedule schedule = dem2d::plan_steps(cut, 1e-6);
  const std::vector<double> force{0.0, 2.0, 1.0, 3.0, 0.0};
  const bool right = schedule.step > 0.0 && schedule.step <= 1e-6 && peaks::peak_statistics(force).count() == 2;
  std::puts(right ? "as expected" : "not as expected");
  return right ? 0 : 1;
}
