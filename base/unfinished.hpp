#pragma once
/// Files that are not whole yet, and folders for temporary use: what must not stay when the program ends before its
/// time. An `Unfinished` removes them when it goes out of scope; a program that has to end without unwinding calls
/// `remove_unfinished`.

#include <filesystem>
#include <vector>

namespace bitrock::base {

class Unfinished {
 public:
  Unfinished();
  /// Begins with one file.
  explicit Unfinished(const std::filesystem::path& path) : Unfinished() { add(path); }
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  /// Call before the file or folder is made.
  void add(const std::filesystem::path& path);
  /// All of them are whole now, or have another name.
  void keep();

 private:
  friend void remove_unfinished();
  std::vector<std::filesystem::path> paths_;
};

/// Removes what is unfinished in all threads. From then on a thread that begins or ends such a file waits for ever, so
/// that nothing new can come: the caller ends the program.
void remove_unfinished();

}  // namespace bitrock::base
