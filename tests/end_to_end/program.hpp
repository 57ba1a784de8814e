#pragma once
/// Runs the built `bitrock` program as a user would: arguments in, exit status and printed text out.

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace program {

struct Outcome {
  int status = -1;   ///< exit status; -1 when a signal ended it
  std::string text;  ///< standard output and error together
};

/// A command of the shell.
inline Outcome shell(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  return outcome;
}

inline Outcome run(const std::string& arguments) {
  return shell(std::string(BITROCK_PROGRAM) + " " + arguments + " 2>&1");
}

/// Whether the program said these words.
inline bool has(const Outcome& outcome, const std::string& words) {
  return outcome.text.find(words) != std::string::npos;
}

/// Starts the program without waiting for it.
inline pid_t start(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::vector<char*> argv{const_cast<char*>(BITROCK_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(BITROCK_PROGRAM, argv.data());
  ::_exit(127);
}

inline nlohmann::json json(const std::filesystem::path& path) {
  return nlohmann::json::parse(base::read_whole(path));
}

/// A study of 4 short, fast cuts in a small bed (about 200 discs): a second or two.
inline std::string small_study() {
  return "rock = \"" BITROCK_SOURCE_DIR
         "/campaigns/rocks/article.toml\"\n"
         "seeds = [3]\n"
         "[grid]\ncutter_speeds_m_per_s = [1, 2]\ndepths_of_cut_mm = [2]\nback_rakes_deg = [10, 25]\n"
         "[cut]\ncut_length_mm = 8\n[bed]\nlength_mm = 24\nheight_mm = 12\n";
}

}  // namespace program
