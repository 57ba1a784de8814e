#pragma once
/// The rocks of a campaign: each size of bed and seed is made once and kept in a file. The first job that needs a rock
/// makes it while others that need it wait, in this program and in others that run on the same folder.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "dem2d/specimen/specimen.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

class RockStore {
 public:
  /// `on_stage` is told when a rock is made; may be empty.
  RockStore(std::filesystem::path folder, std::function<void(const std::string&)> on_stage)
      : folder_(std::move(folder)), on_stage_(std::move(on_stage)) {}

  /// Read or made. Safe to call from several threads.
  std::shared_ptr<const dem2d::Specimen> get(const Job& job);

 private:
  struct Rock {
    std::mutex mutex;
    std::weak_ptr<const dem2d::Specimen> specimen;  ///< kept in memory for as long as a job uses it
  };

  std::filesystem::path folder_;
  std::function<void(const std::string&)> on_stage_;
  std::mutex mutex_;  ///< of the map; each rock has its own
  std::map<std::filesystem::path, Rock> rocks_;
};

/// Whether a good rock for this job is there already.
bool has_rock(const std::filesystem::path& folder, const Job& job);

}  // namespace bitrock::studies
