// The FMU of a bit in the hands of an importer: the runtime's own forces to the last bit, whatever the steps.
#include <cmath>

#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/constant_speed.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/laws/progression_angle.hpp"
#include "surrogate/net/model_file.hpp"
#include "tests/export/fmu_inputs.hpp"

using namespace bitrock;

namespace {

using namespace fmu_test;
using importer::Instance, importer::Outputs;

TEST_F(Fmu, SpeaksTheVersionOfTheStandard) {
  EXPECT_STREQ(library.fmi2GetVersion(), "2.0");
  EXPECT_STREQ(library.fmi2GetTypesPlatform(), "default");
}

TEST_F(Fmu, GivesTheBitsOfSignalAtConstantRates) {
  const runtime::ConstantSpeed drive{
      .rotation = turning, .rate_of_penetration = advancing, .duration = 4.0, .rate = 1000.0};
  const runtime::Signal expected = runtime::constant_speed_signal(bit, model, drive);
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(turning, advancing, pushing), importer::ok) << instance.log;
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.time_s.size(); ++i) {
    if (i > 0) {
      ASSERT_EQ(instance.step(expected.time_s[i - 1], expected.time_s[i]), importer::ok) << instance.log;
    }
    const Outputs seen = instance.get();
    ASSERT_EQ(seen.angle, expected.angle_rad[i]);
    ASSERT_EQ(seen.torque, expected.torque_N_m[i]) << i;
    ASSERT_EQ(seen.axial_force, expected.axial_force_N[i]) << i;
    ASSERT_EQ(seen.depth, expected.summary.depth_of_cut_m);
    largest = std::max(largest, seen.torque);
  }
  EXPECT_GT(largest, 10.0);
  EXPECT_EQ(instance.get().questions, expected.summary.clamps.asked);
  EXPECT_EQ(instance.get().clamped, expected.summary.clamps.clamped());
}

TEST_F(Fmu, GivesTheBitsOfTheCInterfaceWhileRatesChange) {
  const runtime::CoreDescription description = runtime::describe(bit, model);
  std::size_t bytes = 0;
  ASSERT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_OK);
  std::vector<double> memory(bytes / sizeof(double) + 1);
  bitrock_core* core = nullptr;
  ASSERT_EQ(bitrock_core_create(memory.data(), bytes, &description.plain, &core), BITROCK_OK);

  Instance instance(library, guid, resources);
  const double first_rotation = rotation_at(0.0), first_rop = rop_at(0.0), h = 1e-3;
  ASSERT_EQ(instance.start(first_rotation, first_rop, weight_at(0.0)), importer::ok) << instance.log;
  bitrock_load load{};
  ASSERT_EQ(bitrock_core_accept(core, 0.0, first_rotation, first_rop), BITROCK_OK);
  ASSERT_EQ(bitrock_core_update(core, 0.0, first_rotation, first_rop, &load), BITROCK_OK);
  EXPECT_EQ(instance.get().torque, load.torque_N_m);

  double angle = 0.0, angle_since = 0.0, since = 0.0, cutting = first_rotation, begin = 0.0, last_step = 0.0;
  int off = 0, standing = 0;
  for (int i = 0; i < 8000; ++i) {
    const double t = h * i, end = t + (h * (i + 1) - t), speed = rotation_at(t), push = weight_at(t);
    if (const double now = runtime::progression(speed, push, 0.0); now != cutting) {
      angle_since = angle_since + cutting * (begin - since) + runtime::missing_angle(cutting, now, last_step);
      since = begin;
      cutting = now;
    }
    last_step = end - begin;
    begin = end;
    angle = std::max(angle, angle_since + cutting * (end - since));
    double rotation = 0.0, rop = 0.0;
    ASSERT_EQ(bitrock_core_averages(core, &rotation, &rop), BITROCK_OK);
    ASSERT_EQ(bitrock_core_update(core, angle, rotation, rop, &load), BITROCK_OK);
    ASSERT_EQ(bitrock_core_accept(core, end, speed, rop_at(t)), BITROCK_OK);
    const Outputs seen = run(instance, i, 1, h).front();
    ASSERT_EQ(seen.angle, angle) << i;
    ASSERT_EQ(seen.torque, push > 0.0 ? load.torque_N_m : 0.0) << i;
    ASSERT_EQ(seen.axial_force, push > 0.0 ? load.axial_force_N : 0.0) << i;
    off += push > 0.0 ? 0 : 1;
    standing += speed > 0.0 ? 0 : 1;
  }
  EXPECT_GT(off, 500);
  EXPECT_GT(standing, 500);
  bitrock_tally tally{};
  ASSERT_EQ(bitrock_core_tally(core, &tally), BITROCK_OK);
  EXPECT_EQ(instance.get().questions, tally.asked);
}

TEST_F(Fmu, IsTheSameForEveryStepWhileInputsDoNotChange) {
  Instance fine(library, guid, resources), coarse(library, guid, resources), uneven(library, guid, resources);
  for (Instance* instance : {&fine, &coarse, &uneven})
    ASSERT_EQ(instance->start(turning, advancing, pushing), importer::ok) << instance->log;
  for (int i = 0; i < 40; ++i) {
    const double t = 0.125 * i;
    for (int k = 0; k < 64; ++k) fine.step(t + k / 512.0, t + (k + 1) / 512.0);
    coarse.step(t, t + 0.125);
    uneven.step(t, t + 0.03125);
    uneven.step(t + 0.03125, t + 0.125);
    Outputs seen = coarse.get();
    seen.questions = fine.get().questions;  // one step is longer than a window: some are skipped, and never asked about
    seen.clamped = fine.get().clamped;
    ASSERT_EQ(fine.get(), seen) << i;
    ASSERT_EQ(fine.get().torque, uneven.get().torque) << i;
    ASSERT_EQ(fine.get().axial_force, uneven.get().axial_force) << i;
  }
  EXPECT_GT(fine.get().questions, 100);
}

/// The article's swings: 60 rpm and 15 m/h, by these shares, twice a second.
struct Swing {
  double of_rotation, of_advance;
};

/// Outputs at every millisecond from 1 s to 4 s.
std::vector<Outputs> swung(Instance& instance, const Swing& swing, int steps_a_millisecond) {
  const double h = 1e-3 / steps_a_millisecond;
  const auto set = [&](double t) {
    const double sine = std::sin(4.0 * std::numbers::pi * t), later = std::sin(4.0 * std::numbers::pi * t + 1.0);
    return instance.set(2.0 * std::numbers::pi * (1.0 + swing.of_rotation * sine),
                        15.0 / 3600.0 * (1.0 + swing.of_advance * later), pushing);
  };
  EXPECT_EQ(instance.start(2.0 * std::numbers::pi, 15.0 / 3600.0, pushing), importer::ok);
  std::vector<Outputs> seen;
  for (int i = 0; i < 4000 * steps_a_millisecond; ++i) {
    if (i >= 1000 * steps_a_millisecond && i % steps_a_millisecond == 0) seen.push_back(instance.get());
    set(h * i);
    instance.step(h * i, h * (i + 1));
  }
  return seen;
}

// The table of docs/reference/formats.md: how far two runs with other steps are apart while the inputs change, for the
// shipped networks and the shipped bit.
TEST_F(Fmu, OtherStepsGiveNearlyTheSameForceWhileInputsChange) {
  const fs::path folder = dir / "shipped";
  const surrogate::Model shipped =
      surrogate::read_model(fs::path(BITROCK_SOURCE_DIR) / "campaigns/paper240/model.json");
  base::write_whole(dir / "shipped.fmu", fmu::fmu_file(bit, shipped).bytes);
  unpack(dir / "shipped.fmu", folder);
  const std::string its_guid = fmu_test::parse(base::read_whole(folder / "modelDescription.xml")).at("guid");
  for (const auto& [name, swing] :
       {std::pair{"rotation", Swing{0.8, 0.0}}, std::pair{"rate of penetration", Swing{0.0, 0.8}},
        std::pair{"both", Swing{0.8, 0.8}}}) {
    const auto run_with = [&, swing = swing](int steps_a_millisecond) {
      Instance instance(library, its_guid, uri(folder / "resources"));
      return swung(instance, swing, steps_a_millisecond);
    };
    const std::vector<Outputs> fine = run_with(20);
    fmt::print("| {} |", name);
    for (const int steps : {1, 2, 5, 10}) {
      const std::vector<Outputs> coarse = run_with(steps);
      for (const auto component : {&Outputs::torque, &Outputs::axial_force}) {
        double apart = 0.0, square = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i) {
          apart += std::pow(coarse[i].*component - fine[i].*component, 2);
          square += std::pow(fine[i].*component, 2);
        }
        const double share = std::sqrt(apart / square);
        fmt::print("{}{:.1f} %{}", component == &Outputs::torque ? " " : ", ", 100.0 * share,
                   component == &Outputs::torque ? "" : " |");
        EXPECT_LT(share, 0.05) << name << " " << 1.0 / steps << " ms";
      }
    }
    fmt::print("\n");
  }
}

}  // namespace
