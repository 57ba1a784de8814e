#include "base/unfinished.hpp"

#include <algorithm>
#include <mutex>

namespace bitrock::base {

namespace {

struct Register {
  std::mutex mutex;
  std::vector<Unfinished*> all;
};

/// Never destroyed: threads may still work while the program ends.
Register& the_register() {
  static auto* const all = new Register;
  return *all;
}

void remove(const std::vector<std::filesystem::path>& paths) {
  std::error_code ignored;
  for (const std::filesystem::path& path : paths) std::filesystem::remove_all(path, ignored);
}

}  // namespace

Unfinished::Unfinished() {
  const std::lock_guard lock(the_register().mutex);
  the_register().all.push_back(this);
}

Unfinished::~Unfinished() {
  const std::lock_guard lock(the_register().mutex);
  remove(paths_);
  std::erase(the_register().all, this);
}

void Unfinished::add(const std::filesystem::path& path) {
  const std::lock_guard lock(the_register().mutex);
  paths_.push_back(path);
}

void Unfinished::keep() {
  const std::lock_guard lock(the_register().mutex);
  paths_.clear();
}

void remove_unfinished() {
  the_register().mutex.lock();  // and never unlocked
  for (const Unfinished* unfinished : the_register().all) remove(unfinished->paths_);
}

}  // namespace bitrock::base
