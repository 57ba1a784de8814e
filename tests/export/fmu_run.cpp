// Runs an unpacked FMU with changing inputs and prints its outputs as the bits of doubles: nothing of bitrock is
// linked, so it can be built for Windows as well, and what both print be compared.
//   fmu_run LIBRARY GUID RESOURCE-URI
#include <cmath>

#include "tests/export/fmu_importer.hpp"

namespace {

void print(double time, const importer::Outputs& outputs) {
  std::printf("%.3f", time);
  for (const double value : {outputs.torque, outputs.axial_force, outputs.angle, outputs.depth}) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    std::printf(" %08x%08x", static_cast<unsigned>(bits >> 32), static_cast<unsigned>(bits));
  }
  std::printf(" %d %d\n", outputs.questions, outputs.clamped);
}

int run(const char* path, const char* guid, const char* location) {
  const importer::Library library = importer::load(path);
  importer::Instance bit(library, guid, location);
  if (bit.component == nullptr || bit.start(12.0, 4e-3, 1e5) != importer::ok) {
    std::fprintf(stderr, "%s\n", bit.log.c_str());
    return 1;
  }
  for (int i = 0; i < 3000; ++i) {
    const double t = 1e-3 * i;
    const double shape = std::fabs(std::fmod(t, 0.5) - 0.25);  // no sine: mathematics libraries differ
    const std::vector<char> before = bit.state();
    for (int attempt = 0; attempt < 2; ++attempt) {
      if (bit.set(12.0 + 8.0 * shape, 4e-3 * (1.0 - shape), 1e5) != importer::ok) return 1;
      if (bit.step(t, t + (attempt == 0 ? 0.2 : 1e-3)) != importer::ok) return 1;  // the first step is taken back
      if (attempt == 0 && bit.set_state(before) != importer::ok) return 1;
    }
    if (i % 100 == 0) print(t, bit.get());
  }
  return library.fmi2Terminate(bit.component);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  try {
    return run(arguments[1], arguments[2], arguments[3]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
