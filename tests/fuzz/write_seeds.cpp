// Writes the seeds of all readers: `fuzz_seeds FOLDER` makes FOLDER/<reader>/seed_1 and so on, and prints the readers.
#include <cstdio>
#include <filesystem>

#include "base/files.hpp"
#include "tests/fuzz/targets.hpp"

using namespace bitrock;

int main(int count, char** arguments) {
  if (count != 2) return 2;
  for (const fuzz::Target& target : fuzz::all_targets()) {
    const std::filesystem::path folder = std::filesystem::path(arguments[1]) / target.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : target.seeds) base::write_whole(folder / ("seed_" + std::to_string(++number)), seed);
    std::puts(target.name.c_str());
  }
}
