// Programs of the system: their arguments, what they print, how they end.
#include "base/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using base::run_program;

TEST(RunProgram, ArgumentsArriveAsTheyAre) {
  const auto end = run_program({"printf", "%s|", "two words", "$HOME", "`date`", "a;b", "\"", ""});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.output, "two words|$HOME|`date`|a;b|\"||");
}

TEST(RunProgram, TellsHowItEnded) {
  const auto failed = run_program({"sh", "-c", "echo seen; echo why >&2; exit 7"});
  EXPECT_EQ(failed.status, 7);
  EXPECT_EQ(failed.output, "seen\nwhy\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).status, 137);
  EXPECT_EQ(run_program({"cat"}).output, "") << "standard input must be empty";
}

TEST(RunProgram, LongOutputIsWhole) {
  // 600 000 bytes: more than a pipe holds
  EXPECT_EQ(run_program({"sh", "-c", "for i in 1 2 3 4 5 6; do head -c 100000 /dev/zero; done"}).output.size(),
            600000u);
}

TEST(RunProgram, AMissingProgramIsAnError) {
  EXPECT_FALSE(base::is_installed("no-such-program"));
  EXPECT_TRUE(base::is_installed("sh"));
  EXPECT_THROW(run_program({"no-such-program"}), base::SimulationError);
}

TEST(RunProgram, EndsWithTheUsersStop) {
  base::stop_requested() = true;
  EXPECT_THROW(run_program({"sleep", "60"}), base::Interrupted);
  base::stop_requested() = false;
}

TEST(RunProgram, WhatItHasStartedEndsToo) {
  const scratch::Folder folder("group");
  const std::string number = (folder / "number").string();
  std::jthread stop([&] {
    while (!std::filesystem::exists(number)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    base::stop_requested() = true;
  });
  EXPECT_THROW(
      run_program({"sh", "-c", "trap '' TERM INT; sleep 60 & echo $! > n; mv n number; wait; sleep 60"}, folder.path()),
      base::Interrupted);
  base::stop_requested() = false;
  const pid_t sleeper = std::stoi(base::read_whole(number));
  bool alive = true;
  for (int i = 0; i < 200 && alive; ++i) {
    // once its parent is gone the system reaps it, or it stays as a zombie that does nothing
    alive = ::kill(sleeper, 0) == 0 &&
            base::read_whole("/proc/" + std::to_string(sleeper) + "/stat").find(") Z") == std::string::npos;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(alive);
}

TEST(RunProgram, WorksInTheFolderItIsGiven) {
  const scratch::Folder folder("it's; $HOME");
  EXPECT_EQ(run_program({"sh", "-c", "echo new > name; cat name"}, folder.path()).output, "new\n");
  EXPECT_EQ(base::read_whole(folder / "name"), "new\n");
  EXPECT_THROW(run_program({"true"}, folder / "missing"), base::SimulationError);
}

TEST(RunProgram, PipesEndItAsUsual) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(run_program({"bash", "-c", "yes | head -1; echo ${PIPESTATUS[0]}"}).output, "y\n141\n");
  std::signal(SIGPIPE, before);
}

}  // namespace
