#include "base/temporary_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

/// The words of the library for a failed attempt, and what to do.
[[noreturn]] void fail(const std::string& where, int error) {
  const bool full = error == ENOSPC || error == EDQUOT;
  const std::string what = fmt::format("cannot make a temporary folder in {}: {}", where, std::strerror(error));
  if (full) throw OutputError(what + " (make room, or let TMPDIR name another folder)");
  throw InputError(what + " (let the environment variable TMPDIR name a folder that can be written to)");
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const char* wanted = std::getenv("TMPDIR");
  const std::string where = wanted != nullptr && *wanted != '\0' ? wanted : "/tmp";
  std::string name = (std::filesystem::absolute(where) / "bitrock_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail(where, errno);
  path_ = name;
  remover_.add(path_);
}

}  // namespace bitrock::base
