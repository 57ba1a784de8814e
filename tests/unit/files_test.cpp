// A file with its final name is whole; failures say why and leave nothing behind.
#include "base/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>

#include "base/errors.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

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

TEST(Files, WhatIsNoFileIsRefusedAtOnce) {
  const scratch::Folder folder("no_files");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink(folder / "two", folder / "one");
  std::filesystem::create_symlink(folder / "one", folder / "two");
  std::filesystem::create_symlink(folder / "pipe", folder / "link");
  const auto expect_refused = [](const std::filesystem::path& path, const std::string& words) {
    try {
      base::read_whole(path);
      ADD_FAILURE() << path << " was read";
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  expect_refused(folder / "pipe", "is a pipe (a file is needed; save what comes through the pipe to one)");
  expect_refused(folder / "link", "is a pipe");
  expect_refused("/dev/zero", "is a device");
  expect_refused(folder.path(), "is a folder");
  expect_refused(folder / "one", "Too many levels of symbolic links");
  EXPECT_TRUE(base::is_there(folder / "one")) << "so that it is read and refused";
  EXPECT_FALSE(base::is_there(folder / "three"));
  EXPECT_THROW(base::write_whole(folder / "pipe", "x"), base::OutputError) << "nobody reads from it";
  EXPECT_THROW(base::write_whole(folder / "one", "x"), base::InputError);
  EXPECT_THROW(base::require_writable(folder / "one"), base::InputError);
}

TEST(Files, AFileLargerThanMemoryIsRefusedBeforeItIsRead) {
  const scratch::Folder folder("large");
  base::write_whole(folder / "sparse", "");
  std::filesystem::resize_file(folder / "sparse", std::uintmax_t{1} << 40);
  EXPECT_THROW(base::read_whole(folder / "sparse"), base::InputError);
}

mode_t rights_of(const std::filesystem::path& path) {
  struct stat found;
  EXPECT_EQ(::stat(path.c_str(), &found), 0);
  return found.st_mode & 07777;
}

TEST(Files, TheRightsOfWhatIsReplacedStayAndNewFilesFollowTheUmask) {
  const scratch::Folder folder("rights");
  const mode_t before = ::umask(027);
  base::write_whole(folder / "new", "x");
  ::umask(before);
  EXPECT_EQ(rights_of(folder / "new"), 0640u);
  for (const mode_t mode : {0600u, 0664u, 0444u}) {
    ASSERT_EQ(::chmod((folder / "new").c_str(), mode), 0);
    base::write_whole(folder / "new", "y");
    EXPECT_EQ(rights_of(folder / "new"), mode);
  }
}

std::vector<std::string> names_in(const scratch::Folder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Files, APartIsGoneWhetherItIsPutInPlaceOrNot) {
  const scratch::Folder folder("part_file");
  const auto path = folder / "picture.png";
  {
    const base::PartFile part(path);
    EXPECT_EQ(names_in(folder), std::vector<std::string>{part.name().filename()});
  }
  EXPECT_TRUE(names_in(folder).empty()) << "left in the middle, as by an exception or Ctrl-C";
  base::PartFile part(path);
  part.put_in_place();
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"picture.png"});
}

TEST(Files, PartsOfTheDeadAreClearedBeforeAComputationAndThoseOfTheLivingStay) {
  const scratch::Folder folder("left_over");
  const auto path = folder / "run.h5", old = folder / "run.h5.1.0badcafe.part";
  const base::PartFile living(path);
  base::write_whole(folder / "run.h5.1.00000000.part", "just now");
  base::write_whole(old, "an hour ago");
  for (const auto& part : {old, living.name()}) {
    const auto hour_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
    std::filesystem::last_write_time(part, hour_ago);
  }
  base::require_writable(path);
  EXPECT_FALSE(std::filesystem::exists(old));
  EXPECT_TRUE(std::filesystem::exists(living.name())) << "it is locked by its writer";
  EXPECT_TRUE(std::filesystem::exists(folder / "run.h5.1.00000000.part")) << "its writer may be about to lock it";
}

}  // namespace
