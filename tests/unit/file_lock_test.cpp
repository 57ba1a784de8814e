#include "base/file_lock.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using base::FileLock;

TEST(FileLock, ExcludesOthersForAsLongAsItLives) {
  const scratch::Folder dir("lock");
  const auto file = dir / "result.h5";
  EXPECT_FALSE(FileLock::is_held(file));
  {
    const FileLock lock(file);
    EXPECT_TRUE(FileLock::is_held(file));
    EXPECT_FALSE(FileLock::try_take(file).has_value());
    EXPECT_THROW(FileLock{file}, base::InputError);
    EXPECT_TRUE(FileLock::try_take(dir / "other.h5").has_value());
  }
  EXPECT_FALSE(FileLock::is_held(file));
  EXPECT_TRUE(FileLock::try_take(file).has_value());
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".lock")) << "nothing is left";
}

TEST(FileLock, MovesWithItsOwner) {
  const scratch::Folder dir("lock_moves");
  std::optional<FileLock> first = FileLock::try_take(dir / "a");
  ASSERT_TRUE(first.has_value());
  {
    const FileLock second = *std::move(first);
    first.reset();
    EXPECT_TRUE(FileLock::is_held(dir / "a")) << "the empty shell of a moved lock frees nothing";
  }
  EXPECT_FALSE(FileLock::is_held(dir / "a"));
}

TEST(FileLock, DiesWithAKilledProgram) {
  const scratch::Folder dir("lock_killed");
  const auto file = dir / "a", ready = dir / "ready";
  const pid_t child = ::fork();
  if (child == 0) {
    const FileLock lock(file);
    base::write_whole(ready, "held");
    for (;;) ::pause();
  }
  while (!std::filesystem::exists(ready)) ::usleep(1000);
  EXPECT_TRUE(FileLock::is_held(file));
  EXPECT_FALSE(FileLock::try_take(file).has_value());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".lock")) << "the killed program could not remove it";
  EXPECT_FALSE(FileLock::is_held(file));
  EXPECT_TRUE(FileLock::try_take(file).has_value());
}

TEST(FileLock, WaitingEndsWhenTheUserStopsTheProgram) {
  const scratch::Folder dir("lock_stopped");
  const FileLock lock(dir / "a");
  base::stop_requested() = true;
  EXPECT_THROW(FileLock::wait_for(dir / "a"), base::Interrupted);
  base::stop_requested() = false;
  const FileLock other = FileLock::wait_for(dir / "b");  // free: no waiting
  EXPECT_TRUE(FileLock::is_held(dir / "b"));
}

TEST(Files, PartsOfKilledProgramsAreRemovedAndNothingElse) {
  const scratch::Folder dir("parts");
  for (const char* name : {"run_1.h5", "run_1.h5.123.0.part", "run_1.h5.9.17.part", "run_12.h5.123.0.part", "run_1"}) {
    base::write_whole(dir / name, "x");
  }
  base::remove_parts(dir / "run_1.h5");
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(dir.path())) left.push_back(entry.path().filename());
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"run_1", "run_1.h5", "run_12.h5.123.0.part"}));
}

}  // namespace
