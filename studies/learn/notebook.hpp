#pragma once
/// What a folder of `learn` remembers between calls: what it was begun with, how long its batches are, the time spent.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace bitrock::studies {

struct LearnNotebook {
  std::string request;       ///< fingerprint of everything that decides the cuts
  std::vector<int> batches;  ///< cuts of each, in order; of the last one some may be missing
  double elapsed = 0.0;      ///< on the clock [s]
};

inline constexpr const char* notebook_name = "learn.json";  ///< of its file

/// An empty one where the folder has none. Throws `base::InputError` for a file that is damaged.
LearnNotebook read_notebook(const std::filesystem::path& folder);

/// Written aside, then renamed.
void write_notebook(const std::filesystem::path& folder, const LearnNotebook& notebook);

}  // namespace bitrock::studies
