// Peaks of my own force record: reads a table of time and force and prints the five numbers that the networks learn.
// Needs the component peaks alone: none of bitrock's other packages has to be there.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=peaks && cmake --build build/examples
//   build/examples/peaks examples/force_record.csv
//
// Prints the highest and the mean peak, how many peaks lie in each band, and the share of the time without force.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "peaks/statistics.hpp"
#include "peaks/zero_force.hpp"

using namespace bitrock;

namespace {

/// Second column of a file with a line of names, then a row a sample.
std::vector<double> read_force(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<double> force;  // [N/m]
  while (std::getline(file, line)) force.push_back(std::stod(line.substr(line.find(',') + 1)));
  return force;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: peaks FORCE.csv\n"), 2;
  const std::vector<double> force = read_force(arguments[1]);
  if (force.empty()) return std::fprintf(stderr, "peaks: %s holds no samples\n", arguments[1]), 2;

  const peaks::PeakStatistics statistics = peaks::peak_statistics(force);
  const peaks::ZeroForce quiet = peaks::zero_force(force, peaks::minimum_height(force));
  std::printf("samples       %zu\n", force.size());
  std::printf("highest peak  %.2f kN/m\n", statistics.amax / 1e3);
  std::printf("mean peak     %.2f kN/m\n", statistics.amean / 1e3);
  std::printf("peaks         %d: %d above 75 %% of the highest, %d from 25 to 75 %%, %d below\n", statistics.count(),
              statistics.np1, statistics.np23, statistics.np4);
  std::printf("no force      %.0f %% of the time, in %zu periods\n", 100.0 * quiet.quiet_share(), quiet.periods);
}
