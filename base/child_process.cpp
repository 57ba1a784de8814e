#include "base/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <vector>

#include "base/errors.hpp"
#include "base/stop.hpp"

extern char** environ;  // what a child inherits; POSIX gives it no header

namespace bitrock::base {

namespace {

constexpr int look_up_every_ms = 100;  // for a stop wished by the user

/// Closes a descriptor when it goes out of scope.
struct Descriptor {
  int number = -1;
  ~Descriptor() { close(); }
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

[[noreturn]] void fail(const std::string& program, int error) {
  throw SimulationError(fmt::format("cannot run {}: {}", program, std::strerror(error)));
}

/// Programs that run, each the head of a group of processes. The lock is held while one is started, so that none
/// escapes `end_programs`.
struct Running {
  std::mutex mutex;
  std::vector<pid_t> all;
};

/// Never destroyed: threads may still work while bitrock ends.
Running& running() {
  static auto* const all = new Running;
  return *all;
}

/// A program gets a group of its own, so that what it starts can be ended with it, and a SIGPIPE that works.
void set_signals_and_group(posix_spawnattr_t& attributes) {
  sigset_t pipe;
  ::sigemptyset(&pipe);
  ::sigaddset(&pipe, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &pipe);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
}

/// Starts the program with both outputs going to `sink`.
pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& folder, int sink) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, sink, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, sink, STDERR_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  set_signals_and_group(attributes);
  pid_t child = 0;
  int error = 0;
  {
    const std::lock_guard lock(running().mutex);
    error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
    if (error == 0) running().all.push_back(child);
  }
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(arguments[0], error);
  return child;
}

/// The number of a process is free for others once it has been waited for; so it is forgotten just before.
int wait_for(pid_t child) {
  siginfo_t seen{};
  while (::waitid(P_PID, static_cast<id_t>(child), &seen, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  {
    const std::lock_guard lock(running().mutex);
    std::erase(running().all, child);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Reads until the program has closed its outputs; false when the user stops bitrock before.
bool collect(int source, std::string& output) {
  std::array<char, 4096> buffer{};
  while (!stop_requested()) {
    pollfd waiting{.fd = source, .events = POLLIN, .revents = 0};
    if (::poll(&waiting, 1, look_up_every_ms) <= 0) continue;
    const ssize_t count = ::read(source, buffer.data(), buffer.size());
    if (count == 0) return true;
    if (count > 0) output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return false;
}

}  // namespace

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = (std::filesystem::path(folder) / program).string();
    std::error_code ignored;
    if (::access(file.c_str(), X_OK) == 0 && !std::filesystem::is_directory(file, ignored)) return true;
  }
  return false;
}

ProgramEnd run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(arguments.at(0), errno);
  Descriptor source{ends[0]}, sink{ends[1]};
  const pid_t child = start(arguments, folder, sink.number);
  sink.close();
  ProgramEnd end;
  // what it makes is thrown away when the user stops, so there is nothing that it could still bring in order
  if (!collect(source.number, end.output)) ::kill(-child, SIGKILL);
  end.status = wait_for(child);
  throw_if_stopped();
  return end;
}

void end_programs() {
  running().mutex.lock();  // and never unlocked
  for (const pid_t child : running().all) ::kill(-child, SIGKILL);
}

}  // namespace bitrock::base
