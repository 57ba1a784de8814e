// What is not whole does not stay; folders for temporary use go with their object.
#include "base/unfinished.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/temporary_folder.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

namespace fs = std::filesystem;

TEST(Unfinished, IsRemovedUnlessKept) {
  const scratch::Folder folder("unfinished");
  {
    base::Unfinished part(folder / "part"), whole(folder / "whole");
    base::write_whole(folder / "part", "half");
    base::write_whole(folder / "whole", "all");
    whole.keep();
  }
  EXPECT_FALSE(fs::exists(folder / "part"));
  EXPECT_TRUE(fs::exists(folder / "whole"));
}

TEST(Unfinished, AllOfThemGoWhenTheProgramHasToEnd) {
  const scratch::Folder folder("ended");
  const pid_t child = ::fork();
  if (child == 0) {
    const base::Unfinished part(folder / "part"), files(folder / "folder");
    fs::create_directories(folder / "folder/in/it");
    base::write_whole(folder / "part", "half");
    base::write_whole(folder / "finished", "all");
    base::remove_unfinished();
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(fs::exists(folder / "part"));
  EXPECT_FALSE(fs::exists(folder / "folder"));
  EXPECT_TRUE(fs::exists(folder / "finished"));
}

TEST(TemporaryFolder, GoesWithItsObject) {
  fs::path path;
  {
    const base::TemporaryFolder folder;
    path = folder.path();
    base::write_whole(path / "file", "something");
    EXPECT_TRUE(fs::is_directory(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryFolder, AWrongPlaceIsTheUsersError) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/no/such/folder", 1);
  try {
    const base::TemporaryFolder folder;
    ADD_FAILURE() << folder.path();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("TMPDIR"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("/no/such/folder"), std::string::npos) << error.what();
  }
  if (before != nullptr) ::setenv("TMPDIR", kept.c_str(), 1);
  if (before == nullptr) ::unsetenv("TMPDIR");
}

}  // namespace
