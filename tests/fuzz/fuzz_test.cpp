// Every reader takes its seeds, refuses or takes seeds that were changed a little, and refuses or takes what fuzzers
// have found (tests/fuzz/findings/<reader>/): never a crash, never another exception.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/random.hpp"
#include "tests/fuzz/targets.hpp"

using namespace bitrock;

namespace {

class Reader : public testing::TestWithParam<fuzz::Target> {};

/// One of the changes that files suffer: a byte, a piece that is missing, doubled, moved, another number.
std::string changed(std::string bytes, base::Random& random) {
  static const std::vector<std::string> words{
      "-",  "0",    "nan", "inf",  "1e999", "-1", "1e308", "\"",   "'", "[]", "[[", "\n", ",",
      ",,", "null", "{}",  "true", "0x14",  "1e", "\x80",  "\xff", ".", "=",  "#",  "%",  "99999999999"};
  if (bytes.empty()) return words[base::below(random, words.size())];
  const std::size_t at = base::below(random, bytes.size()),
                    length = 1 + base::below(random, std::min<std::size_t>(40, bytes.size() - at));
  switch (base::below(random, 6)) {
    case 0:
      bytes[at] = static_cast<char>(base::below(random, 256));
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.insert(base::below(random, bytes.size()), bytes.substr(at, length));
      break;
    case 3:
      bytes.resize(at);
      break;
    case 4:
      bytes.replace(at, 1, std::string(1 + base::below(random, 8), base::below(random, 2) == 0 ? '\0' : '\xff'));
      break;
    default: {
      const std::string& word = words[base::below(random, words.size())];
      bytes.replace(at, std::min<std::size_t>(word.size(), bytes.size() - at), word);
    }
  }
  return bytes;
}

void read_or_refuse(const fuzz::Target& target, const std::string& bytes) {
  try {
    target.read(bytes);
  } catch (const base::InputError&) {
  }
}

TEST_P(Reader, TakesItsSeeds) {
  ASSERT_FALSE(GetParam().seeds.empty());
  for (const std::string& seed : GetParam().seeds) EXPECT_NO_THROW(GetParam().read(seed));
}

TEST_P(Reader, TakesOrRefusesChangedSeeds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(1);
  base::Random random(1);
  for (int round = 0; round < 300 && Clock::now() < end; ++round) {
    for (const std::string& seed : GetParam().seeds) {
      std::string bytes = seed;
      for (std::size_t changes = 1 + base::below(random, 3); changes > 0; --changes) bytes = changed(bytes, random);
      EXPECT_NO_THROW(read_or_refuse(GetParam(), bytes)) << "in round " << round;
    }
  }
}

TEST_P(Reader, TakesOrRefusesWhatFuzzersFound) {
  const std::filesystem::path findings =
      std::filesystem::path(BITROCK_SOURCE_DIR) / "tests/fuzz/findings" / GetParam().name;
  if (!std::filesystem::exists(findings)) GTEST_SKIP() << "nothing found";
  for (const auto& entry : std::filesystem::directory_iterator(findings)) {
    EXPECT_NO_THROW(read_or_refuse(GetParam(), base::read_whole(entry.path()))) << entry.path();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Reader, testing::ValuesIn(fuzz::all_targets()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
