#pragma once
/// Strength tests on synthetic rock, as a rock mechanics laboratory does them: uniaxial compression between platens,
/// the same in a cell under pressure (triaxial), direct tension by gripped ends, the same with a saw cut through the
/// middle of the core (toughness), and the Brazilian test of a disc squeezed across its diameter.
///
/// **Equation.** With the mean F of the forces at the two ends, per metre of thickness,
///
///     ucs, tension:  stress = F / width            brazilian:  stress = 2 F / (pi D)
///     triaxial:      stress = F / width, above the confining pressure p: strength along the load = p + largest stress
///     toughness:     stress = F / width, also over the cut; K_Ic of its largest value by notch.hpp
///
/// strain and lateral strain are the slopes of the plane fitted to the displacements of all discs of the middle half of
/// the core (strain.hpp), so that neither platens nor grips enter; in the Brazilian test strain is the shortening of
/// the loaded diameter over D, in that of toughness the stretching between the grips over their distance. Then
///
///     strength       = largest stress
///     E              = stress / strain and nu = -lateral strain / strain, secants from 0 to half the strength
///     crack initiation stress = stress when 1 % of the cracks that exist at the peak exist
///     uncracked E and nu = the same secants, from 0 to the first crack, where that is below half the strength
///
/// **Triaxial.** The core floats in the fluid of the cell, which presses on its outer face (fluid/mud.hpp) all round,
/// so it may bulge and split; it is brought to rest under p first (specimen/press.hpp), and strains count from there.
/// The fluid is behind the platens, too, so that they carry only what is above p. It does not enter the core, as
/// through a jacket. In two dimensions there is no intermediate stress.
///
/// **Signs.** Stress and strains are positive in compression in `ucs`, `triaxial` and `brazilian`, in extension in
/// `tension` and `toughness`.
///
/// **Symbols.** F [N/m]; width, D [m]; stress, E [Pa]; strain, nu [1].
///
/// **Source.** Secant modulus to half the strength: [IsrmUniaxial1979]; Brazilian formula: [IsrmTensile1978]; platens
/// and grips that move at both ends, stop at a share of the peak: the public test files that go with [Potyondy2015].
/// That part of the curve holds cracks in nearly every rock under compression, as in the laboratory; where they open so
/// far that nu is not that of an elastic body, `warnings` says so.
/// The 1 % rule for crack initiation is a convention of bonded-particle work [PotyondyCundall2004].
///
/// **End.** Cores are loaded until the stress has fallen to 0.8 of its peak. The halves of a split Brazilian disc can
/// carry more than the disc did; its strength is the load at primary fracture [IsrmTensile1978], so it is loaded only
/// until the stress has fallen to 0.95 of its peak. A core under pressure may go on by friction without a fall: then
/// its strength is the largest stress up to `largest_strain`. No fall counts before there are cracks enough for a
/// fracture through the core: width over the largest grain's diameter, times the share of joints that were bonded. A
/// core with unbonded joints is severed also when it stays below 0.1 of its peak.
///
/// **Differences and validity.** The loading is dynamic and slow (loading_rate.hpp); `LabRun::imbalance` says how far
/// it is from equilibrium. A core starts with the velocity field of uniform straining, so no wave runs through it when
/// the loading begins. The stress of a sample is a mean over its interval, the strain is that of its end: E comes out
/// 0.1 to 0.2 % low. The Brazilian disc is made of whole grains within its circle, so its rim is about a grain short
/// and its strength some percent low. Contacts with platens that come after the start are not in the critical step; its
/// margin (step/step.hpp) covers them. After the peak, when the core falls to pieces, strains of the middle half mean
/// little.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/config.hpp"
#include "base/progress.hpp"
#include "dem2d/specimen/genesis.hpp"

namespace bitrock::dem2d {

/// What is done to a core.
enum class LabTest {
  ucs,        ///< uniaxial compression between platens
  tension,    ///< direct tension, held at both ends
  brazilian,  ///< a disc pressed across its diameter
  triaxial,   ///< compression under a confining pressure
  toughness   ///< tension of a core with a saw cut
};

/// All of them.
inline constexpr std::array lab_tests{LabTest::ucs, LabTest::tension, LabTest::brazilian, LabTest::triaxial,
                                      LabTest::toughness};

/// Whether grips hold the ends of the core and pull; else platens push.
constexpr bool pulls(LabTest test) {
  return test == LabTest::tension || test == LabTest::toughness;
}

/// Whether the test gives E and nu: a Brazilian disc and a core with a cut do not strain alike everywhere.
constexpr bool strains_evenly(LabTest test) {
  return test != LabTest::brazilian && test != LabTest::toughness;
}

/// Core and loading of a test.
struct LabSettings {
  double width = 50e-3;             ///< of the core; brazilian: diameter of the disc [m]
  double height = 100e-3;           ///< of the core; not used by brazilian [m]
  double strain_rate = 0.0;         ///< [1/s]; 0: default_strain_rate
  double local_damping = 0.1;       ///< alpha; the same as of a cut (loading_rate.hpp) [1]
  double platen_friction = 0.0;     ///< [1]
  double confining_pressure = 0.0;  ///< p of a triaxial test [Pa]
  double notch_length = 0.0;        ///< 2 a, of the cut of a toughness test [m]
  double grip_height = 2e-3;        ///< of each end held in tension; at least 1.5 largest diameters are held [m]
  double stop_fraction =
      0.0;  ///< the test ends when the stress has fallen to this share of the peak [1]; 0: 0.8, brazilian 0.95
  double largest_strain = 0.0;  ///< at which a test without a peak is given up [1]; 0: 5 times what is expected,
                                ///< 25 times with unbonded joints, 2.5 times under pressure
};

/// One point of the curve: means over the steps since the point before.
struct LabSample {
  double strain, lateral_strain;     ///< [1]
  double stress;                     ///< [Pa]
  int cracks_tensile, cracks_shear;  ///< elements broken so far, by mode
};

/// All discs at one instant.
struct LabState {
  std::vector<double> x, y, radius;  ///< [m]
  std::vector<int> id;               ///< a number a disc keeps
  std::vector<int> fragment;         ///< discs with the same number hang together by bonded joints; 0 is the largest
  double low, high;                  ///< where the platens, or the inner ends of the grips, are [m]
};

/// What one test gave.
struct LabRun {
  LabTest test;                          ///< that was made
  std::uint64_t seed = 0;                ///< of the specimen
  double width = 0.0, height = 0.0;      ///< of the specimen's box [m]
  double confining_pressure = 0.0;       ///< p [Pa]; 0 but in a triaxial test
  double notch_length = 0.0;             ///< 2 a [m]; 0 but in a toughness test
  int discs = 0, joints = 0;             ///< at the start
  double peak_stress = 0.0;              ///< the strength, above p [Pa]
  double strain_at_peak = 0.0;           ///< [1]
  double fracture_toughness = 0.0;       ///< K_Ic [Pa sqrt(m)]; NaN but in a toughness test
  double youngs_modulus = 0.0;           ///< [Pa]; brazilian, toughness: NaN, the test does not give it
  double poissons_ratio = 0.0;           ///< [1]; brazilian, toughness: NaN
  double uncracked_modulus = 0.0;        ///< [Pa]; before the first crack; NaN: there is no such part, or as above
  double uncracked_ratio = 0.0;          ///< [1]; as above
  int cracks_at_half = 0;                ///< at half the strength
  double crack_initiation_stress = 0.0;  ///< [Pa]
  int cracks_tensile = 0, cracks_shear = 0, cracks_at_peak = 0;  ///< elements broken, by mode, and those of the peak
  double fracture_height =
      0.0;  ///< of cores that are pulled: median height of the cracks over the core's height [1]; others: NaN
  double imbalance = 0.0;        ///< mean difference of the two end forces up to the peak, over the peak force [1]
  double strain_rate = 0.0;      ///< [1/s]
  double step = 0.0;             ///< [s]
  long long steps = 0;           ///< taken in all
  double wall_time = 0.0;        ///< [s]
  std::vector<LabSample> curve;  ///< stress over strain
  std::vector<Crack> cracks;     ///< in order of time
  LabState last;                 ///< for the picture
};

/// The name used on the command line and in files: ucs, tension, brazilian, triaxial, toughness.
const char* name_of(LabTest test);
/// The test of this name; throws `InputError` for any other.
LabTest lab_test_named(const std::string& name);

/// Allowed pressures: ten times the mud pressure of the deepest wells.
inline constexpr base::Range confining_pressure_MPa{.low = 0.0, .high = 1000.0};

/// Allowed lengths of the cut over the width of the core: within them the formula of notch.hpp holds, and there is rock
/// on both sides to break.
inline constexpr base::Range notch_over_width{.low = 0.02, .high = 0.9};
/// Where the user does not say [1].
inline constexpr double usual_notch_over_width = 0.4;

/// Throws `InputError` beginning with `source` when the settings make no test of this rock.
void check_lab_settings(LabTest test, const Rock& rock, const LabSettings& settings, const std::string& source);

/// What is allowed but hardly wanted, in words: a core of few grains.
std::vector<std::string> warnings(LabTest test, const Rock& rock, const LabSettings& settings);

/// What the result does not mean: a Poisson's ratio that is not that of an elastic body.
std::vector<std::string> warnings(const LabRun& run);

/// Discs with springs along their centre lines alone have this Poisson's ratio in two dimensions, and shear springs
/// only lower it (tests/verification/lattice_test.cpp): what is above comes from cracks.
inline constexpr double largest_elastic_ratio = 1.0 / 3.0;

/// Width and height of the specimen that a test needs: for the Brazilian test the box around its disc.
struct LabBox {
  double width, height;  ///< [m]
};
/// The size of the core that a test needs.
LabBox specimen_box(LabTest test, const LabSettings& settings);

/// Tests one specimen on one core; only `specimen.rock`'s joints and contacts decide its strength, so that they may be
/// exchanged after packing. Throws `SimulationError` when the core does not break within `largest_strain` or has no
/// strength or stiffness, and `Interrupted` when the user stops.
LabRun run_lab_test(LabTest test, const Specimen& specimen, const LabSettings& settings,
                    const base::ProgressCallback& progress = {});

}  // namespace bitrock::dem2d
