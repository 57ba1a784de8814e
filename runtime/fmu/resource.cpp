#include "runtime/fmu/resource.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#ifdef _WIN32
#include <windows.h>
#endif

namespace bitrock::fmu {

namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Behind `prefix`, letters of any case; null when `text` does not begin so.
const char* behind(const char* text, const char* prefix) {
  for (; *prefix != '\0'; ++text, ++prefix) {
    const char c = *text >= 'A' && *text <= 'Z' ? static_cast<char>(*text + ('a' - 'A')) : *text;
    if (c != *prefix) return nullptr;
  }
  return text;
}

#ifdef _WIN32
/// A letter, a colon: a drive of Windows.
bool begins_with_drive(const char* text) {
  const char c = static_cast<char>(text[0] | 0x20);
  return c >= 'a' && c <= 'z' && text[1] == ':';
}
#endif

/// The path part of a location; null when there is none here.
const char* path_part(const char* location, bool& encoded) {
  encoded = true;
  const char* rest = behind(location, "file:");
  if (rest == nullptr) {
    encoded = false;
    return std::strstr(location, "://") == nullptr ? location : nullptr;
  }
  if (const char* const local = behind(rest, "//localhost/"); local != nullptr) rest = local - 1;
  if (const char* const local = behind(rest, "///"); local != nullptr) rest = local - 1;
#ifdef _WIN32
  if (rest[0] == '/' && begins_with_drive(rest + 1)) ++rest;
  return rest;
#else
  return rest[0] == '/' && rest[1] != '/' ? rest : nullptr;
#endif
}

#ifdef _WIN32
std::FILE* open_file(const char* path) {
  static_assert(sizeof(wchar_t) == 2);
  wchar_t wide[longest_path];
  if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, longest_path) == 0) return nullptr;
  return _wfopen(wide, L"rb");
}
#else
std::FILE* open_file(const char* path) {
  return std::fopen(path, "rb");
}
#endif

}  // namespace

bool resource_path(const char* location, const char* file, char (&path)[longest_path]) {
  bool encoded = false;
  const char* from = path_part(location, encoded);
  if (from == nullptr || *from == '\0') return false;
  std::size_t length = 0;
  const std::size_t most = longest_path - std::strlen(file) - 2;  // a / and the zero
  for (; *from != '\0'; ++from) {
    char c = *from;
    if (encoded && c == '%') {
      const int high = hex_digit(from[1]), low = high < 0 ? -1 : hex_digit(from[2]);
      if (low < 0 || (high == 0 && low == 0)) return false;
      c = static_cast<char>(16 * high + low);
      from += 2;
    }
    if (length == most) return false;
    path[length++] = c;
  }
  if (path[length - 1] != '/') path[length++] = '/';
  std::memcpy(path + length, file, std::strlen(file) + 1);
  return true;
}

FileBytes read_file(const char* path, std::size_t most) {
  std::FILE* const file = open_file(path);
  if (file == nullptr) return {};
  FileBytes read;
  const long size = std::fseek(file, 0, SEEK_END) == 0 ? std::ftell(file) : -1;
  if (size > 0 && static_cast<unsigned long>(size) <= most && std::fseek(file, 0, SEEK_SET) == 0) {
    read = {static_cast<char*>(std::malloc(static_cast<std::size_t>(size))), static_cast<std::size_t>(size)};
    if (read.bytes != nullptr && std::fread(read.bytes, 1, read.size, file) != read.size) {
      std::free(read.bytes);
      read = {};
    }
  }
  std::fclose(file);
  return read;
}

}  // namespace bitrock::fmu
