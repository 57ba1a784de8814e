// A step of the FMU of a string takes no memory: hosts call it from threads that must not wait.
#include <atomic>
#include <cstdlib>

#include "tests/export/string_fmu_fixture.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BITROCK_OWN_MALLOC 0  // sanitizers have one of their own
#else
#define BITROCK_OWN_MALLOC 1
#endif

#if BITROCK_OWN_MALLOC
namespace {
std::atomic<long> times_taken{0};
}
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_realloc(void* memory, std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++times_taken;
  return __libc_malloc(size);
}
extern "C" void* realloc(void* memory, std::size_t size) {
  ++times_taken;
  return __libc_realloc(memory, size);
}

namespace {

using fmu_test::StringFile, fmu_test::StringFmu, fmu_test::StringInstance;

TEST_F(StringFmu, AStepTakesNoMemory) {
  for (const fmu_test::fs::path& file :
       {written("short", fmu_test::short_well), source / "campaigns/drill/normal.toml"}) {
    const StringFile fmu = exported(file);
    const long before_made = times_taken;
    StringInstance string(fmu);
    EXPECT_GT(times_taken, before_made) << "what the library takes is seen here";
    ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
    const unsigned rotation = fmu.references.at("set_rotation_rad_per_s");
    const double speed = 5.0;
    const long before = times_taken;
    for (int i = 0; i < 1000; ++i) {  // the uppermost segment of the well is split meanwhile
      fmu.library.fmi2SetReal(string.fmu.component, &rotation, 1, &speed);
      fmu.library.fmi2DoStep(string.fmu.component, 0.01 * i, 0.01, 0);
    }
    EXPECT_EQ(times_taken, before);
    EXPECT_NEAR(string["string_time_s"], 10.0, 1e-3) << string.fmu.log;
  }
}

}  // namespace
#endif
