// A cut: a small bed of the article's rock is packed and cut by a PDC cutter; prints what the rock does to the cutter.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=cut && cmake --build build/examples
//   build/examples/cut PREFIX/share/bitrock/campaigns/rocks/article.toml
//
// Prints discs and joints of the bed, mean forces per metre of cutter width, specific energy and cracks.
#include <cstdio>
#include <exception>

#include "dem2d/cut/run_cut.hpp"

using namespace bitrock;

namespace {

void cut_rock(const char* rock_file) {
  dem2d::CutCase cut;
  cut.rock = dem2d::read_rock(rock_file);
  cut.rock.radius_min = 0.32e-3;  // [m] finer grains than the file has
  cut.rock.radius_max = 0.48e-3;
  cut.rock.installation_gap = 0.032e-3;
  cut.cutter_speed = 2.0;     // [m/s]
  cut.depth_of_cut = 1.5e-3;  // [m]
  cut.back_rake = 0.2618;     // [rad] 15 degrees
  cut.cut_length = 12e-3;     // [m]
  cut.bed_length = 24e-3;
  cut.bed_height = 8e-3;
  dem2d::check_cut_case(cut, "my cut");

  // A seed is a rock: another one packs other discs and puts the weak joints elsewhere.
  const std::uint64_t seed = 1;
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, seed, 1);
  const dem2d::CutRun run = dem2d::run_cut(cut, bed);

  std::printf("bed              %d discs, %d joints\n", run.discs, run.joints);
  std::printf("cut              %.1f mm in %lld steps of %.0f ns\n", run.cut_length * 1e3, run.steps, run.step * 1e9);
  std::printf("force along x    %.1f kN/m, resists the cut\n", run.mean_force_x / 1e3);
  std::printf("force along y    %.1f kN/m, pushes the cutter out\n", run.mean_force_y / 1e3);
  std::printf("specific energy  %.1f MPa\n", run.specific_energy / 1e6);
  std::printf("cracks           %d in tension, %d in shear\n", run.cracks_tensile, run.cracks_shear);
  std::printf("energy not found %.2g of the cutter's work\n", run.energy_residual_fraction);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 2) return std::fprintf(stderr, "usage: cut ROCK.toml\n"), 2;
    cut_rock(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cut: %s\n", error.what());
    return 1;
  }
}
