// The bits of two small specimens, cut and core are pinned: what is computed by another engine must not count as done.
// The same for any number of threads, any vector unit, any build. Rock and cuts stand here in full, so that nothing but
// the engine can change them.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/physics_version.hpp"
#include "studies/calibrate/laboratory.hpp"

using namespace bitrock;

namespace {

/// The bytes of numbers one after the other, lowest first.
class Bits {
 public:
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(int value) { add(static_cast<std::uint64_t>(value)); }
  template <class T>
  void add(const std::vector<T>& values) {
    for (const T& value : values) add(value);
  }
  void add(const dem2d::Crack& crack) {
    for (const double value : {crack.time, crack.x, crack.y, crack.normal_angle, crack.length}) add(value);
    for (const int value : {static_cast<int>(crack.mode), crack.disc1, crack.disc2}) add(value);
  }
  std::string fingerprint() const { return base::fingerprint_text(bytes_); }

 private:
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<char>(word >> shift));
  }

  std::string bytes_;
};

std::string bits_of(const dem2d::Specimen& specimen) {
  Bits bits;
  bits.add(specimen.x);
  bits.add(specimen.y);
  bits.add(specimen.radius);
  bits.add(specimen.disc1);
  bits.add(specimen.disc2);
  return bits.fingerprint();
}

std::string bits_of(const dem2d::CutRun& run) {
  Bits bits;
  bits.add(run.time);
  bits.add(run.force_x);
  bits.add(run.force_y);
  bits.add(run.cracks);
  return bits.fingerprint();
}

std::string bits_of(const dem2d::LabRun& run) {
  Bits bits;
  bits.add(run.peak_stress);
  bits.add(run.youngs_modulus);
  bits.add(run.poissons_ratio);
  bits.add(run.cracks);
  return bits.fingerprint();
}

/// Strengths from joint to joint, as in the article's rock.
dem2d::Rock plain_rock() {
  return {.radius_min = 0.5e-3,
          .radius_max = 0.75e-3,
          .density = 2500.0,
          .porosity = 0.1,
          .joint_modulus = 1.5e9,
          .joint_stiffness_ratio = 3.5,
          .tensile_strength = 12e6,
          .cohesion = 60e6,
          .friction = 0.577,
          .elements = 2,
          .installation_gap = 0.05e-3,
          .tensile_strength_deviation = 3e6,
          .cohesion_deviation = 15e6,
          .contact_modulus = 1.5e9,
          .contact_stiffness_ratio = 3.5,
          .contact_friction = 0.577,
          .contact_damping_ratio = 0.5,
          .packing_modulus = 1e9,
          .packing_damping = 0.7,
          .packing_pressure = 60e6,
          .equilibrium_ratio = 1e-4};
}

/// All that a rock can have.
dem2d::Rock rich_rock() {
  dem2d::Rock rock = plain_rock();
  rock.fine_depth = 4e-3;
  rock.coarse_ratio = 1.5;
  rock.friction_angle = 0.2;
  rock.elements = 3;
  rock.radius_multiplier = 0.9;
  rock.gapped_fraction = 0.05;
  rock.slit_fraction = 0.05;
  rock.initial_gap = 0.01e-3;
  rock.residual_cohesion = 2e6;
  rock.drop_to_residual = true;
  rock.contact_shear_damping_ratio = 0.1;
  return rock;
}

/// 5 mm long, 2 mm deep, all of the bed in motion.
dem2d::CutCase plain_cut() {
  return {.rock = plain_rock(),
          .cutter_speed = 2.0,
          .depth_of_cut = 2e-3,
          .back_rake = 0.25,
          .cut_length = 5e-3,
          .cutter_diameter = 13e-3,
          .cutter_thickness = 8e-3,
          .cutter_friction = 0.3,
          .bed_length = 24e-3,
          .bed_height = 12e-3,
          .local_damping = 0.1,
          .sampling_distance = 20e-6,
          .domain_margin = 20e-3};
}

/// Only the neighbourhood of the cutter moves, and the start is not recorded.
dem2d::CutCase rich_cut() {
  dem2d::CutCase cut = plain_cut();
  cut.rock = rich_rock();
  cut.run_in = 1e-3;
  cut.moving_ahead = 10e-3;
  cut.moving_behind = 4e-3;
  return cut;
}

dem2d::Specimen bed_of(const dem2d::CutCase& cut, int threads = 1) {
  return dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, threads);
}

struct Pin {
  int version;                ///< of what has these bits
  std::string first, second;  ///< bits of the two things computed
};

/// Who changed bits on purpose raises the version named `what` in `file`, and then writes it and the new bits here.
void expect_pinned(const Pin& pin, int version, const std::string& first, const std::string& second,
                   const std::string& changed, const std::string& what, const std::string& file) {
  const std::string now =
      "{.version = " + std::to_string(version) + ", .first = \"" + first + "\", .second = \"" + second + "\"}";
  if (version == pin.version) {
    EXPECT_TRUE(first == pin.first && second == pin.second)
        << "the bits of " << changed << " changed: raise " << what << " in " << file << "\nthey are now " << now;
  } else {
    EXPECT_TRUE(false) << what << " is another: what is pinned here is now " << now;
  }
}

TEST(PinnedBits, OfASpecimen) {
  const Pin pin{.version = 3, .first = "a6b0bec9cdcd8bd5", .second = "3e366a1e99ae51d3"};
  expect_pinned(pin, dem2d::genesis_version, bits_of(bed_of(plain_cut())), bits_of(bed_of(rich_cut())), "a specimen",
                "genesis_version", "dem2d/specimen/genesis.hpp");
}

TEST(PinnedBits, OfACut) {
  const Pin pin{.version = 5, .first = "31f29cb61b58e67b", .second = "c4cb3f496051ab68"};
  const dem2d::CutRun plain = dem2d::run_cut(plain_cut(), bed_of(plain_cut()));
  const dem2d::CutRun rich = dem2d::run_cut(rich_cut(), bed_of(rich_cut()));
  EXPECT_GT(plain.cracks.size(), 50u) << "a cut in which nothing happens pins nothing";
  EXPECT_GT(rich.cracks.size(), 50u);
  expect_pinned(pin, dem2d::physics_version, bits_of(plain), bits_of(rich), "a cut", "physics_version",
                "dem2d/step/physics_version.hpp");
}

TEST(PinnedBits, OfACoreInCompressionAndInTension) {
  const Pin pin{.version = 1, .first = "1bacbbb790eb95a9", .second = "fc7db2b8d8c8a10d"};
  const dem2d::Specimen core = dem2d::make_specimen(plain_rock(), 15e-3, 30e-3, 3, 1);
  const auto bits = [&](dem2d::LabTest test) {
    dem2d::LabSettings settings;
    settings.width = core.width;
    settings.height = core.height;
    return bits_of(dem2d::run_lab_test(test, core, settings));
  };
  expect_pinned(pin, studies::laboratory_version, bits(dem2d::LabTest::ucs), bits(dem2d::LabTest::tension),
                "a laboratory test", "laboratory_version", "studies/calibrate/laboratory.hpp");
}

TEST(PinnedBits, AreThoseOfEveryVectorUnitAndNumberOfThreads) {
  dem2d::CutCase cut = rich_cut();
  cut.cut_length = 1.5e-3;
  const std::string bed = bits_of(bed_of(cut)), run = bits_of(dem2d::run_cut(cut, bed_of(cut)));
  int threads = 1;
  for (std::int64_t left = hwy::SupportedTargets(); left > 0; left &= left - 1) {
    threads = 3 - threads;
    hwy::SetSupportedTargetsForTest(left & -left);
    const dem2d::Specimen packed = bed_of(cut, threads);
    const std::string here = bits_of(dem2d::run_cut(cut, packed, {.threads = threads}));
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_EQ(bits_of(packed), bed) << hwy::TargetName(left & -left) << ", " << threads << " threads";
    EXPECT_EQ(here, run) << hwy::TargetName(left & -left) << ", " << threads << " threads";
  }
}

}  // namespace
