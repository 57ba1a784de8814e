// A file with its final name is whole; failures say why and leave nothing behind.
#include "base/files.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "tests/scratch.hpp"

namespace {

TEST(Files, WriteThenReadGivesTheSameBytes) {
  const scratch::Folder folder("files");
  const auto path = folder / "whole.bin";
  const std::string bytes("a\0b\n", 4);
  base::write_whole(path, bytes);
  EXPECT_EQ(base::read_whole(path), bytes);
}

TEST(Files, AFullDiskIsACleanFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THROW(base::write_whole("/dev/full", "x"), base::SimulationError);
}

TEST(Files, MissingFolderAndMissingFile) {
  EXPECT_THROW(base::read_whole("/nonexistent/file"), base::InputError);
  EXPECT_THROW(base::read_whole("/"), base::InputError);
  EXPECT_THROW(base::require_writable("/proc/no/file"), base::InputError);
  EXPECT_THROW(base::write_whole("/nonexistent/file", "x"), base::OutputError);
  EXPECT_THROW(base::require_writable(""), base::InputError);
  EXPECT_THROW(base::require_writable(std::string(300, 'x')), base::InputError);
  const scratch::Folder folder("names");
  EXPECT_THROW(base::require_writable((folder / "new").string() + "/"), base::InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  EXPECT_NO_THROW(base::require_writable(folder / "new/file"));
}

TEST(Files, ALinkStaysALinkAndItsTargetIsWritten) {
  const scratch::Folder folder("links");
  base::write_whole(folder / "target", "old");
  std::filesystem::create_symlink(folder / "target", folder / "link");
  base::require_writable(folder / "link");
  base::write_whole(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(base::read_whole(folder / "target"), "new");
}

TEST(Files, AnOutputMustBeNeitherInputNorAnotherOutput) {
  EXPECT_NO_THROW(base::refuse_overwriting({"a", ""}, {"b", "", "/dev/null", "/dev/null"}));
  EXPECT_THROW(base::refuse_overwriting({"a"}, {"./x/../a"}), base::InputError);
  EXPECT_THROW(base::refuse_overwriting({"a"}, {"b", "./b"}), base::InputError);
}

}  // namespace
