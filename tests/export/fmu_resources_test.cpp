// What an FMU is made of when it is loaded: it must be found however an importer names it, and whatever is missing,
// damaged or of another FMU makes no instance and does no harm.
#include <cmath>

#include "base/random.hpp"
#include "base/text.hpp"
#include "tests/export/fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::Fmu;
using importer::Instance;
namespace fs = std::filesystem;

TEST_F(Fmu, IsMadeOnlyOfWhatBelongsTogether) {
  const auto expect_none = [this](const std::string& id, const std::string& location, const std::string& words,
                                  int type = 1) {
    Instance instance(library, id, location, type);
    EXPECT_EQ(instance.component, nullptr);
    EXPECT_NE(instance.log.find(words), std::string::npos) << instance.log << "\nlacks: " << words;
  };
  expect_none("{00000000-0000-0000-0000-000000000000}", resources, "guid '{00000000-");
  expect_none(guid, resources, "only co-simulation", 0);
  expect_none(guid, uri(dir / "nowhere"), "nowhere/bit.block' cannot be read");
  expect_none(guid, uri(unpacked), "cannot be read");
  expect_none(guid, "http://example.org/resources", "must be a URI of a local file");
  expect_none(guid, "file://elsewhere/resources", "must be a URI of a local file");
  expect_none(guid, "file:///tmp/a%2", "must be a URI of a local file");
  expect_none(guid, "file:///tmp/a%00b", "must be a URI of a local file");
  expect_none(guid, "", "must be a URI of a local file");
  expect_none(guid, "file:///" + std::string(5000, 'a'), "must be a URI of a local file");
  const importer::Callbacks silent{};
  EXPECT_EQ(library.fmi2Instantiate("bit", 1, "", resources.c_str(), &silent, 0, 0), nullptr);
  EXPECT_EQ(library.fmi2Instantiate("bit", 1, guid.c_str(), nullptr, &silent, 0, 0), nullptr);
  EXPECT_EQ(library.fmi2Instantiate(nullptr, 1, guid.c_str(), resources.c_str(), &silent, 0, 0), nullptr);
  EXPECT_EQ(library.fmi2Instantiate("bit", 1, guid.c_str(), resources.c_str(), nullptr, 0, 0), nullptr);
}

TEST_F(Fmu, FindsItsResourcesHoweverTheyAreNamed) {
  const std::string path = (unpacked / "resources").string(), encoded = resources.substr(7);
  for (const std::string& location :
       {resources + "/", "FILE://" + encoded, "file:" + encoded, "file://localhost" + encoded, path, path + "/"}) {
    Instance instance(library, guid, location);
    EXPECT_NE(instance.component, nullptr) << location << "\n" << instance.log;
  }
}

TEST_F(Fmu, DamagedResourcesMakeNoInstance) {
  const fs::path block_file = unpacked / "resources/bit.block";
  const std::string good = base::read_whole(block_file);
  const auto made_of = [&](const std::string& bytes) {
    base::write_whole(block_file, bytes);
    Instance instance(library, guid, resources);
    EXPECT_EQ(instance.log.empty(), instance.component != nullptr);
    return instance.component != nullptr && instance.start(10.0, 3e-3, 5e4) == importer::ok;
  };
  EXPECT_TRUE(made_of(good));
  for (std::size_t i = 0; i < good.size(); i += i < 200 ? 1 : 211) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x40);
    ASSERT_FALSE(made_of(bad)) << i;
  }
  for (std::size_t size = 0; size < good.size(); size += size < 200 ? 7 : 977)
    ASSERT_FALSE(made_of(good.substr(0, size))) << size;
  EXPECT_FALSE(made_of(good + "12345678"));
  EXPECT_FALSE(made_of(std::string(100000, '\xff')));
  fs::remove(block_file);
  Instance instance(library, guid, resources);
  EXPECT_EQ(instance.component, nullptr);
}

/// Blocks that are wrong and yet have the right checksum: no instance, or one that answers.
TEST_F(Fmu, NoBlockWithARightChecksumDoesHarm) {
  const fs::path block_file = unpacked / "resources/bit.block";
  const std::string good = base::read_whole(block_file);
  base::Random random(11);
  int refused = 0, made = 0;
  for (int trial = 0; trial < 150; ++trial) {
    std::string bad = good;
    // the head of the body, where counts and settings are, as often as the many parameters
    const std::size_t words = (trial % 2 == 0 ? std::size_t{640} : bad.size()) / 8 - 9;
    const std::size_t at = 8 * (9 + base::below(random, words));
    const std::array<std::uint64_t, 6> values{0, 1, 65, UINT64_MAX, std::uint64_t{1} << 61, random()};
    const std::uint64_t value = values[base::below(random, values.size())];
    std::memcpy(bad.data() + at, &value, 8);
    if (trial % 5 == 0) bad.resize(bad.size() - 8 * base::below(random, 20));
    const std::uint64_t size = bad.size(), sum = base::fingerprint(std::string_view(bad).substr(32));
    std::memcpy(bad.data() + 16, &size, 8);
    std::memcpy(bad.data() + 24, &sum, 8);
    base::write_whole(block_file, bad);
    Instance instance(library, guid, resources);
    if (instance.component == nullptr) {
      EXPECT_FALSE(instance.log.empty());
      ++refused;
      continue;
    }
    ++made;
    if (instance.start(10.0, 3e-3, 5e4) != importer::ok) continue;
    for (int i = 0; i < 20; ++i) {
      if (instance.step(0.1 * i, 0.1 * (i + 1)) != importer::ok) break;
      EXPECT_TRUE(std::isfinite(instance.get().torque));
    }
  }
  EXPECT_GT(refused, 25);
  EXPECT_GT(made, 25);
}

}  // namespace
