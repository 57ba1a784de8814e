// Programs of the system: their arguments, what they print, how they end.
#include "base/child_process.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/stop.hpp"

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

}  // namespace
