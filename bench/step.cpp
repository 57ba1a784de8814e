// What one step of the engine costs: bonded rock at rest and rock that is being cut, on one thread and on two, where
// the time goes, what each trick is worth, how much memory a disc takes. Every number stands beside a hash of what was
// computed, and the program fails when two ways of computing the same disagree. See docs/results/performance.md.
//
//   bench_step [--quick] [--json FILE]      --quick: 5,000 discs only
#include <fmt/format.h>
#include <hwy/targets.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/files.hpp"
#include "base/thread_time.hpp"
#include "bench/scenes.hpp"
#include "dem2d/step/stages.hpp"

using namespace bitrock;

namespace {

using Clock = std::chrono::steady_clock;

/// One thread: time it has spent on its core, so that a busy machine falsifies little; several: time on the clock [s].
double now(int threads) {
  if (threads > 1) return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  return base::thread_time();
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Timing {
  double best, median;  // [ns] a disc and step
};

Timing time_steps(dem2d::World& world, int steps, int repeats) {
  std::vector<double> times;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double start = now(world.threads);
    double disc_steps = 0.0;
    for (int step = 0; step < steps; ++step) {
      dem2d::advance(world);
      disc_steps += world.discs.count();
    }
    times.push_back((now(world.threads) - start) * 1e9 / disc_steps);
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2]};
}

/// Share of time of each stage on one thread [1].
std::map<std::string, double> stage_shares(dem2d::World world, int steps) {
  std::map<std::string, double> time;
  const auto timed = [&time](const std::string& name, const auto& stage) {
    const auto start = Clock::now();
    stage();
    time[name] += seconds_since(start);
  };
  for (int step = 0; step < steps; ++step) {
    timed("neighbours", [&] { refresh_neighbours(world); });
    timed("copy", [&] { copy_motion(world); });
    timed("joints", [&] { joint_forces(world); });
    timed("contacts", [&] { contact_forces(world); });
    timed("boundaries", [&] { boundary_forces(world); });
    timed("sum", [&] { sum_forces(world); });
    timed("motion", [&] { move(world); });
  }
  double total = 0.0;
  for (const auto& [name, value] : time) total += value;
  for (auto& [name, value] : time) value /= total;
  return time;
}

/// Of all that the steps have computed.
std::string hash(const dem2d::World& world) {
  std::string bytes;
  for (const std::vector<double>* values : {&world.discs.x, &world.discs.y, &world.discs.angle, &world.discs.velocity_x,
                                            &world.discs.spin, &world.joints.shear_stress}) {
    bytes.append(reinterpret_cast<const char*>(values->data()), values->size() * sizeof(double));
  }
  return fmt::format("{:016x}", std::hash<std::string>{}(bytes));
}

double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct Row {
  std::string scene, way;
  int threads = 1;
  Timing timing{};
  std::string hash;
};

void print(const Row& row, const dem2d::World& world, nlohmann::json& out) {
  const double joints = static_cast<double>(world.joints.count()) / world.discs.count();
  fmt::print("| {} | {} | {:.2f} | {} | {:.1f} | {:.1f} | {:.1f} | {} |\n", row.scene, world.discs.count(), joints,
             row.way, row.timing.best, row.timing.median, row.timing.best / joints, row.hash);
  std::fflush(stdout);
  out["steps"].push_back({{"scene", row.scene},
                          {"discs", world.discs.count()},
                          {"joints", world.joints.count()},
                          {"way", row.way},
                          {"threads", row.threads},
                          {"best_ns_per_disc_step", row.timing.best},
                          {"median_ns_per_disc_step", row.timing.median},
                          {"best_ns_per_joint_step", row.timing.best / joints},
                          {"hash", row.hash}});
}

bool failed = false;

void require_same(const std::string& a, const std::string& b, const std::string& what) {
  if (a == b) return;
  fmt::print("FAILED: {} computes something else ({} against {})\n", what, a, b);
  failed = true;
}

/// Times all `worlds` in turn, so that a busy moment hits all of them; they start equal and must end equal.
struct Way {
  std::string name;
  int threads = 1;
  std::int64_t target = 0;  // of Highway; 0: the best
  dem2d::World world;
  bool same_bits = true;
};

void compare(const std::string& scene, std::vector<Way>& ways, int steps, int rounds, nlohmann::json& out) {
  std::vector<std::vector<double>> times(ways.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < ways.size(); ++k) {
      hwy::SetSupportedTargetsForTest(ways[k].target);
      times[k].push_back(time_steps(ways[k].world, steps, 1).best);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  const std::string expected = hash(ways[0].world);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    std::sort(times[k].begin(), times[k].end());
    const std::string seen = hash(ways[k].world);
    if (ways[k].same_bits) require_same(expected, seen, scene + ", " + ways[k].name);
    print({scene, ways[k].name, ways[k].threads, {times[k].front(), times[k][times[k].size() / 2]}, seen},
          ways[k].world, out);
  }
}

void print_shares(const std::string& scene, const dem2d::World& world, int steps, nlohmann::json& out) {
  fmt::print("{}:", scene);
  for (const auto& [name, share] : stage_shares(world, steps)) {
    fmt::print("  {} {:.0f} %", name, 100.0 * share);
    out["stages"][scene][name] = share;
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  std::string json_file;
  std::vector<int> sizes{5000, 20000, 80000};
  for (int k = 1; k < argc; ++k) {
    if (std::string(argv[k]) == "--json" && k + 1 < argc) json_file = argv[++k];
    if (std::string(argv[k]) == "--quick") sizes = {5000};
  }
  const std::filesystem::path folder = "build/bench";
  std::filesystem::create_directories(folder);
  const dem2d::Rock rock = dem2d::read_rock(std::string(BITROCK_SOURCE_DIR) + "/campaigns/rocks/article_fine.toml");
  nlohmann::json out;
  const std::string columns =
      "| scene | discs | joints a disc | way | best ns / disc-step | median | best ns / joint-step | hash |";

  fmt::print("{}\n|---|---|---|---|---|---|---|---|\n", columns);
  std::map<int, double> at_rest;
  for (const int size : sizes) {
    const dem2d::Specimen specimen = bench::slab(rock, size, folder);
    std::vector<Way> ways;
    ways.push_back({.name = "1 thread", .world = bench::trembling_slab(specimen, 1)});
    malloc_trim(0);
    const double before = resident_bytes();
    const dem2d::World copy = ways[0].world;
    const double bytes = (resident_bytes() - before) / copy.discs.count();
    ways.push_back({.name = "2 threads", .threads = 2, .world = bench::trembling_slab(specimen, 2)});
    compare("at rest", ways, std::max(20, 2000000 / size), 15, out);
    out["memory"].push_back({{"discs", ways[0].world.discs.count()}, {"bytes_per_disc", bytes}});
    ways.clear();
    ways.push_back({.name = "1 thread", .world = bench::slab_being_cut(specimen, 1)});
    ways.push_back({.name = "2 threads", .threads = 2, .world = ways[0].world});
    ways[1].world.threads = 2;
    dem2d::prepare(ways[1].world);
    dem2d::prepare(ways[0].world);
    compare("being cut", ways, std::max(20, 2000000 / size), 15, out);
  }
  fmt::print("\nmemory of a world at rest with its lists, as far as it does not fit into pages already there: ");
  for (const auto& memory : out["memory"])
    fmt::print("{:.0f} bytes a disc at {} discs  ", memory["bytes_per_disc"].get<double>(), memory["discs"].get<int>());
  fmt::print("\n\n");

  const dem2d::Specimen specimen = bench::slab(rock, 5000, folder);
  const dem2d::World resting = bench::trembling_slab(specimen, 1), cutting = bench::slab_being_cut(specimen, 1);
  fmt::print("share of time, 5,000 discs, 1 thread\n\n");
  print_shares("at rest", resting, 2000, out);
  print_shares("being cut", cutting, 2000, out);

  fmt::print("\nwhat the tricks are worth, 5,000 discs, 1 thread\n\n{}\n|---|---|---|---|---|---|---|---|\n", columns);
  std::vector<Way> ways;
  ways.push_back({.name = "as it is", .world = cutting});
  for (const auto& [name, target] : {std::pair{"AVX2", HWY_AVX2}, std::pair{"plain code", HWY_EMU128 | HWY_SCALAR}}) {
    ways.push_back({.name = name, .target = static_cast<std::int64_t>(target), .world = cutting});
  }
  ways.push_back({.name = "every joint element by element", .world = cutting, .same_bits = false});
  ways.back().world.reference_path = true;
  compare("being cut", ways, 200, 15, out);
  ways.clear();
  ways.push_back({.name = "in columns", .world = resting});
  ways.push_back(
      {.name = "in the order of packing", .world = bench::trembling_slab(specimen, 1, false), .same_bits = false});
  compare("at rest", ways, 400, 15, out);

  const dem2d::CutCase example = dem2d::read_cut_case(std::string(BITROCK_SOURCE_DIR) + "/campaigns/cuts/example.toml");
  dem2d::World world = dem2d::make_cut_world(
      example, bench::kept_specimen(example.rock, example.bed_length, example.bed_height, 1, folder),
      {.measure_energy = false});
  const auto start = Clock::now();
  const double simulated = 0.01;  // [s]
  while (world.time < simulated) dem2d::advance(world);
  const double per_hour = simulated / seconds_since(start) * 3600.0;
  fmt::print(
      "\nthe article's cut (campaigns/cuts/example.toml, {} discs), 1 thread: {:.1f} simulated seconds an hour\n",
      world.discs.count(), per_hour);
  out["example_simulated_seconds_per_hour"] = per_hour;
  if (!json_file.empty()) base::write_whole(json_file, out.dump(2) + "\n");
  return failed ? 1 : 0;
}
