// What libFuzzer calls. Which reader is under test says the environment: BITROCK_FUZZ_TARGET=rock_toml.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "base/errors.hpp"
#include "tests/fuzz/targets.hpp"

using namespace bitrock;

namespace {

const fuzz::Target& chosen() {
  static const std::vector<fuzz::Target> targets = fuzz::all_targets();
  const char* const name = std::getenv("BITROCK_FUZZ_TARGET");
  for (const fuzz::Target& target : targets) {
    if (name != nullptr && target.name == name) return target;
  }
  std::fputs("BITROCK_FUZZ_TARGET must name one of the readers:\n", stderr);
  for (const fuzz::Target& target : targets) std::fprintf(stderr, "  %s\n", target.name.c_str());
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::Target& target = chosen();
  try {
    target.read({reinterpret_cast<const char*>(bytes), size});
  } catch (const base::InputError&) {  // anything else ends the program, which is a finding
  }
  return 0;
}
