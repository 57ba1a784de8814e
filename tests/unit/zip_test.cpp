// Archives that others can unpack, always with the same bytes.
#include "base/zip.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

TEST(Zip, HasTheLayoutOfTheFormat) {
  // Small enough to count by hand; the checksum of "123456789" is the one that every description of it gives.
  const std::string archive = base::zip_stored({{"a", "123456789"}});
  EXPECT_EQ(archive.size(), (30U + 1 + 9) + (46 + 1) + 22);
  EXPECT_EQ(archive.substr(0, 4), "PK\x03\x04");
  EXPECT_EQ(archive.substr(14, 4), "\x26\x39\xf4\xcb");                      // 0xcbf43926
  EXPECT_EQ(archive.substr(18, 8), std::string("\x09\0\0\0\x09\0\0\0", 8));  // packed and unpacked size
  EXPECT_EQ(archive.substr(10, 4), std::string("\0\0\x21\0", 4));            // 00:00, 1980-01-01
  EXPECT_EQ(archive.substr(40, 4), "PK\x01\x02");
  EXPECT_EQ(archive.substr(87, 4), "PK\x05\x06");
  EXPECT_EQ(archive.substr(87 + 16, 4), std::string("\x28\0\0\0", 4));  // where the directory begins
  EXPECT_EQ(base::zip_stored({}).size(), 22U);
}

TEST(Zip, IsUnpackedByOthers) {
  const scratch::Folder dir{"zip"};
  std::string all_bytes;
  for (int i = 0; i < 70000; ++i) all_bytes += static_cast<char>(i * 7 + i / 256);
  base::write_whole(dir / "x.zip", base::zip_stored({{"empty", ""}, {"deep/er/\xc3\xa4.bin", all_bytes}}));
  const std::string command = "cd '" + dir.path().string() + "' && LC_ALL=C.UTF-8 " BITROCK_CMAKE " -E tar xf x.zip";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(base::read_whole(dir / "deep/er/\xc3\xa4.bin"), all_bytes);
  EXPECT_EQ(base::read_whole(dir / "empty"), "");
}

TEST(Zip, RefusesNamesThatCannotBe) {
  EXPECT_THROW(base::zip_stored({{"", "x"}}), base::InputError);
  EXPECT_THROW(base::zip_stored({{"a", "x"}, {"a", "y"}}), base::InputError);
  EXPECT_THROW(base::zip_stored({{std::string(70000, 'a'), "x"}}), base::InputError);
}

}  // namespace
