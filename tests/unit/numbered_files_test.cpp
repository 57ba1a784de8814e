// Which files of a folder belong to a series, and that no others are touched.
#include "base/numbered_files.hpp"

#include <gtest/gtest.h>

#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

const base::Series frames{.begin = "frame_", .end = ".png", .digits = 4};

TEST(NumberedFiles, OnlyNamesThatTheSeriesWouldWrite) {
  const scratch::Folder dir("numbered");
  for (const char* name : {"frame_0000.png", "frame_0012.png", "frame_12345.png", "frame_7.png", "frame_00012.png",
                           "frame_-001.png", "frame_0x01.png", "frame_.png", "frame_0003.png.gz", "my_frame_0003.png"})
    base::write_whole(dir / name, "x");
  std::vector<long long> numbers;
  for (const base::NumberedFile& file : base::numbered_files(dir.path(), frames)) numbers.push_back(file.number);
  EXPECT_EQ(numbers, (std::vector<long long>{0, 12, 12345}));
  base::remove_numbered_files(dir.path(), frames);
  EXPECT_FALSE(std::filesystem::exists(dir / "frame_0012.png"));
  for (const char* name : {"frame_7.png", "frame_00012.png", "my_frame_0003.png"})
    EXPECT_TRUE(std::filesystem::exists(dir / name)) << name;
}

TEST(NumberedFiles, NoFolderNoFiles) {
  EXPECT_TRUE(base::numbered_files("/no/such/folder", frames).empty());
  base::remove_numbered_files("/no/such/folder", frames);
}

}  // namespace
