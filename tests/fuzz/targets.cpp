#include "tests/fuzz/targets.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>

#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace fuzz {

namespace {

/// Without a flush to the disk, of which a fuzzer would do thousands a second.
void write_quickly(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const auto written = ::write(file, bytes.data(), bytes.size());
  ::close(file);
  if (file < 0 || written != static_cast<ssize_t>(bytes.size())) throw std::runtime_error("cannot write " + path);
}

}  // namespace

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (std::vector<Target>& some : std::vector{config_targets(), table_targets(), hdf5_targets(), runtime_targets()}) {
    for (Target& target : some) all.push_back(std::move(target));
  }
  return all;
}

std::string shipped(const std::string& path) {
  return base::read_whole(std::string(BITROCK_SOURCE_DIR) + "/" + path);
}

void read_as_file(std::string_view bytes, const std::string& name,
                  const std::function<void(const std::string& path)>& reader) {
  static const scratch::Folder folder("fuzz");
  static const bool neighbours = [] {
    write_quickly(folder / "rock.toml", shipped("campaigns/rocks/article.toml"));
    write_quickly(folder / "bit.toml", shipped("campaigns/bits/pdc15.toml"));
    write_quickly(folder / "table.csv", "cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg\n1,2,15\n0.5,1,20\n");
    return true;
  }();
  (void)neighbours;
  const std::string path = folder / name;
  write_quickly(path, bytes);
  reader(path);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from + " in a seed");
  return text.replace(at, from.size(), to);
}

}  // namespace fuzz
