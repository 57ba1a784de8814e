// What one step of the engine costs: bonded rock at rest and rock that is being cut, on one thread and on two, and
// where the time goes. Prints a table; with --json FILE also as JSON. Times are the best and the median of repeats.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/files.hpp"
#include "bench/scenes.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Timing {
  double best, median;  // [ns] a disc and step
};

Timing time_steps(dem2d::World& world, int steps, int repeats) {
  std::vector<double> times;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto start = Clock::now();
    for (int step = 0; step < steps; ++step) dem2d::advance(world);
    times.push_back(seconds_since(start) * 1e9 / (static_cast<double>(steps) * world.discs.count()));
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2]};
}

/// Share of time of each stage on one thread [1].
std::map<std::string, double> stage_shares(dem2d::World& world, int steps) {
  std::map<std::string, double> time;
  const auto timed = [&time](const std::string& name, const auto& stage) {
    const auto start = Clock::now();
    stage();
    time[name] += seconds_since(start);
  };
  for (int step = 0; step < steps; ++step) {
    timed("neighbours", [&] { refresh_neighbours(world); });
    timed("joints", [&] { joint_forces(world); });
    timed("contacts", [&] { contact_forces(world); });
    timed("boundaries", [&] { boundary_forces(world); });
    timed("sum", [&] { sum_forces(world); });
    timed("move", [&] { move(world); });
  }
  double total = 0.0;
  for (const auto& [name, value] : time) total += value;
  for (auto& [name, value] : time) value /= total;
  return time;
}

/// Of all that the step computes: equal for any number of threads.
std::uint64_t hash(const dem2d::World& world) {
  std::string bytes;
  for (const std::vector<double>* values : {&world.discs.x, &world.discs.y, &world.discs.angle, &world.discs.velocity_x,
                                            &world.discs.spin, &world.joints.shear_stress}) {
    bytes.append(reinterpret_cast<const char*>(values->data()), values->size() * sizeof(double));
  }
  return std::hash<std::string>{}(bytes);
}

}  // namespace

int main(int argc, char** argv) {
  std::string json_file;
  std::vector<int> sizes{5000, 20000, 80000};
  for (int k = 1; k < argc; ++k) {
    if (std::string(argv[k]) == "--json" && k + 1 < argc) json_file = argv[++k];
    if (std::string(argv[k]) == "--sizes") {
      sizes.clear();
      while (++k < argc) sizes.push_back(std::atoi(argv[k]));
    }
  }
  const std::filesystem::path folder = "build/bench";
  std::filesystem::create_directories(folder);
  dem2d::Rock rock = dem2d::read_rock(std::string(BITROCK_SOURCE_DIR) + "/campaigns/rocks/article.toml");
  nlohmann::json out;
  fmt::print("{:>9} {:>8} {:>7} {:>8} {:>9} {:>9}  stages (1 thread)\n", "scene", "discs", "joints", "threads", "best",
             "median");
  for (const int size : sizes) {
    const dem2d::Specimen specimen = bench::slab(rock, size, folder);
    const int steps = std::max(20, 4000000 / size);
    for (const int threads : {1, 2}) {
      dem2d::World world = bench::trembling_slab(specimen, threads);
      time_steps(world, steps, 1);
      const Timing timing = time_steps(world, steps, 15);
      fmt::print("{:>9} {:>8} {:>7} {:>8} {:>9.2f} {:>9.2f}  ", "slab", world.discs.count(), world.joints.count(),
                 threads, timing.best, timing.median);
      fmt::print("hash {:016x} ", hash(world));
      if (threads == 1) {
        for (const auto& [name, share] : stage_shares(world, steps)) fmt::print(" {} {:.0f} %", name, 100.0 * share);
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
  }
}
