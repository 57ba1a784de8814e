// What hosts hand to the C interface and to an FMU, as somebody who knows the checksums could make it.
#include <cstdlib>
#include <cstring>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/text.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/core/bitrock_runtime.h"
#include "runtime/fmu/bit_block.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/fmu/resource.hpp"
#include "runtime/fmu/slave.hpp"
#include "runtime/fmu/string_file.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace fuzz {

namespace {

/// Two cutters and networks that answer with few peaks: a small state.
const runtime::CoreDescription& description() {
  static const surrogate::Model model = runtime_test::constant_model(runtime_test::whole_pair());
  static const runtime::CoreDescription plain = [] {
    runtime::Bit bit{.name = "two cutters", .diameter = 0.2};
    bit.signal.window_angle = 1.0;
    for (int i = 1; i <= 2; ++i) {
      bit.cutters.push_back({.number = i, .radius = 0.03 * i, .width = 0.02, .back_rake = 0.3});
    }
    return runtime::describe(bit, model);
  }();
  return plain;
}

/// A core in memory of its own.
class OwnCore {
 public:
  explicit OwnCore(const bitrock_description& plain) {
    std::size_t bytes = 0;
    if (bitrock_core_size(&plain, &bytes) != BITROCK_OK) std::abort();
    memory_ = std::aligned_alloc(16, (bytes + 15) / 16 * 16);
    if (bitrock_core_create(memory_, bytes, &plain, &core_) != BITROCK_OK) std::abort();
  }
  ~OwnCore() { std::free(memory_); }
  OwnCore(const OwnCore&) = delete;
  OwnCore& operator=(const OwnCore&) = delete;
  bitrock_core* get() const { return core_; }

 private:
  void* memory_ = nullptr;
  bitrock_core* core_ = nullptr;
};

std::string saved_state() {
  const OwnCore core(description().plain);
  bitrock_load load{};
  bitrock_core_update(core.get(), 1.5, 10.0, 3e-3, &load);
  for (const double time : {0.0, 0.01, 0.02}) bitrock_core_accept(core.get(), time, 10.0, 3e-3);
  std::size_t bytes = 0;
  bitrock_core_state_size(core.get(), &bytes);
  std::string state(bytes, '\0');
  bitrock_core_save(core.get(), state.data(), bytes);
  return state;
}

std::uint64_t word_at(const std::string& bytes, std::size_t at) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof(word));
  return word;
}

void put_word(std::string& bytes, std::size_t at, std::uint64_t word) {
  if (at + sizeof(word) <= bytes.size()) std::memcpy(bytes.data() + at, &word, sizeof(word));
}

/// Head and checksum of runtime/core/state.cpp: magic, size, fingerprint of the description, checksum.
std::string good_state(std::string_view bytes) {
  static const std::string seed = saved_state();
  std::string state(bytes);
  state.resize(seed.size());
  state.replace(0, 24, seed, 0, 24);
  const std::uint64_t used = word_at(state, 8);
  std::uint64_t sums[4] = {1, 2, 3, used};
  std::size_t lane = 0;
  for (std::size_t at = 32; at + 8 <= used; at += 8) {
    sums[lane] = (sums[lane] ^ word_at(state, at)) * 0x9e3779b97f4a7c15ULL;
    sums[lane] ^= sums[lane] >> 32;
    lane = (lane + 1) % 4;
  }
  std::uint64_t whole = 0;
  for (const std::uint64_t sum : sums) whole = base::mix(whole ^ sum);
  put_word(state, 24, whole);
  return state;
}

void restore_and_go_on(std::string_view bytes) {
  const std::string state = good_state(bytes);
  const OwnCore core(description().plain);
  if (const bitrock_status status = bitrock_core_restore(core.get(), state.data(), state.size());
      status != BITROCK_OK) {
    throw base::InputError(bitrock_status_text(status));
  }
  bitrock_load load{};
  for (const double angle : {1.5, 1.6, 2.5, 0.1, 40.0}) bitrock_core_update(core.get(), angle, 10.0, 3e-3, &load);
  double rotation = 0.0, rate = 0.0;
  bitrock_core_averages(core.get(), &rotation, &rate);
  for (const double time : {0.03, 0.5}) bitrock_core_accept(core.get(), time, 10.0, 3e-3);
  bitrock_core_averages(core.get(), &rotation, &rate);
  bitrock_tally tally{};
  bitrock_core_tally(core.get(), &tally);
}

/// Size and checksum as `fmu::bit_block` writes them.
std::string good_block(std::string_view bytes) {
  std::string block(bytes);
  put_word(block, 16, block.size());
  if (block.size() >= fmu::block_checked_from) {
    put_word(block, 24, base::fingerprint(std::string_view(block).substr(fmu::block_checked_from)));
  }
  return block;
}

void make_and_step(std::string_view bytes) {
  const std::string block = good_block(bytes);
  char* const owned = static_cast<char*>(std::malloc(block.size() + 1));
  std::memcpy(owned, block.data(), block.size());
  const char* reason = nullptr;
  fmu::Slave* const slave = fmu::make(owned, block.size(), reason);
  if (slave != nullptr) {
    constexpr unsigned inputs[] = {0, 1, 2};
    constexpr double values[] = {10.0, 3e-3, 1e4};  // rotation [rad/s], rate of penetration [m/s], weight on bit [N]
    fmu::set_values(*slave, inputs, 3, values);
    fmu::find_start(*slave);
    fmu::step(*slave, 0.01);
  }
  const std::string told = reason == nullptr ? "" : reason;
  fmu::destroy(slave);
  if (!told.empty()) throw base::InputError(told);
}

/// A pendulum in torsion.
std::string small_string_block() {
  fmu::StringContent content{.step = 1e-3};
  content.plane.torsional = {.inertia = {1.0}, .stiffness = {1.0}, .damping = {0.0}, .wall_damping = {0.0}};
  return fmu::string_block(content, "", "{00000000-0000-0000-0000-000000000000}");
}

void read_string(std::string_view bytes) {
  const std::string block = good_block(bytes);
  std::vector<std::uint64_t> words(block.size() / 8 + 1);  // read in place, from an address divisible by 8
  std::memcpy(words.data(), block.data(), block.size());
  fmu::StringBlock read;
  const char* const reason = fmu::read_string_block(words.data(), block.size(), read);
  if (reason != nullptr) throw base::InputError(reason);
}

}  // namespace

std::vector<Target> runtime_targets() {
  return {
      {.name = "core_state", .read = restore_and_go_on, .seeds = {saved_state()}},
      {.name = "fmu_block",
       .read = make_and_step,
       .seeds = {fmu::bit_block(description().plain, 0.0, "{00000000-0000-0000-0000-000000000000}")}},
      {.name = "string_fmu_block", .read = read_string, .seeds = {small_string_block()}},
      {.name = "fmu_folder",
       .read =
           [](std::string_view bytes) {
             static char path[fmu::longest_path];
             if (!fmu::resource_path(std::string(bytes).c_str(), "bit.block", path)) {
               throw base::InputError("no folder");
             }
           },
       .seeds = {"file:///tmp/a%20folder/resources/", "/tmp/resources", "file://localhost/tmp/resources"}},
  };
}

}  // namespace fuzz
