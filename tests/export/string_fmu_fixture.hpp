#pragma once
/// The FMU of a drilling case as `bitrock export fmu --drill` writes it, in the hands of the small importer.

#include <optional>

#include "base/text.hpp"
#include "tests/export/fmu_fixture.hpp"

namespace fmu_test {

/// An FMU that has been unpacked.
struct StringFile {
  std::string guid, resources;
  importer::Library library{};
  Element description;
  std::map<std::string, unsigned> references;  ///< of the variables, by name
};

/// One instance, its variables by name.
class StringInstance {
 public:
  explicit StringInstance(const StringFile& file) : file_(file), fmu(file.library, file.guid, file.resources) {}

  int set(const std::string& name, double value) { return fmu.set_real(file_.references.at(name), value); }
  int choose(const std::string& name, int item) { return fmu.set_integer(file_.references.at(name), item); }
  /// The order of a real importer, with the start values of the description.
  int start(double time = 0.0) {
    int worst = file_.library.fmi2SetupExperiment(fmu.component, 0, 0.0, time, 0, 0.0);
    worst |= file_.library.fmi2EnterInitializationMode(fmu.component);
    return worst | file_.library.fmi2ExitInitializationMode(fmu.component);
  }
  int step(double begin, double end) { return fmu.step(begin, end); }
  double operator[](const std::string& name) {
    const unsigned reference = file_.references.at(name);
    double value = 0.0;
    EXPECT_EQ(file_.library.fmi2GetReal(fmu.component, &reference, 1, &value), importer::ok) << name << fmu.log;
    return value;
  }
  int whole(const std::string& name) {
    const unsigned reference = file_.references.at(name);
    int value = 0;
    EXPECT_EQ(file_.library.fmi2GetInteger(fmu.component, &reference, 1, &value), importer::ok) << name << fmu.log;
    return value;
  }
  /// All real outputs, in the order of the description.
  std::vector<double> outputs() {
    std::vector<double> values;
    for (const Element& variable : file_.description.child("ModelVariables").children) {
      if (variable.at("causality") == "output" && variable.children.at(0).name == "Real")
        values.push_back((*this)[variable.at("name")]);
    }
    return values;
  }

 private:
  const StringFile& file_;

 public:
  importer::Instance fmu;
};

class StringFmu : public FmuFiles {
 protected:
  const scratch::Folder dir{"string fmu 100%"};
  const fs::path source = BITROCK_SOURCE_DIR;

  /// A shipped case with lines put in place of others, each of which it must have; beside the files that it names.
  fs::path changed(const std::string& name, const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = base::read_whole(source / "campaigns/drill" / (name + ".toml"));
    const auto put = [&](const std::string& old, const std::string& fresh) {
      const std::size_t at = text.find(old);
      if (at == std::string::npos) throw std::runtime_error(name + " has no " + old);
      text.replace(at, old.size(), fresh);
    };
    put("\"../bits/", "\"" + (source / "campaigns/bits/").string());
    put("\"../paper240/", "\"" + (source / "campaigns/paper240/").string());
    for (const auto& [old, fresh] : changes) put(old, fresh);
    return written(name, text);
  }
  fs::path written(const std::string& name, const std::string& text) {
    const fs::path file = dir / (name + ".toml");
    base::write_whole(file, text);
    return file;
  }

  StringFile exported(const fs::path& drill, const std::string& more = "") {
    const fs::path file = dir / (drill.stem().string() + ".fmu"), unpacked = dir / drill.stem();
    const auto outcome =
        program::run("export fmu " + more + " --drill " + quoted(drill) + " -o " + quoted(file) + " --quiet");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    fs::remove_all(unpacked);
    unpack(file, unpacked);
    StringFile made{.resources = uri(unpacked / "resources"),
                    .library = importer::load((unpacked / "binaries/linux64/bitrock_string.so").string()),
                    .description = parse(base::read_whole(unpacked / "modelDescription.xml"))};
    made.guid = made.description.at("guid");
    for (const Element& variable : made.description.child("ModelVariables").children)
      made.references[variable.at("name")] = static_cast<unsigned>(std::stoul(variable.at("valueReference")));
    return made;
  }
};

/// A short string in a bent hole that is run in, turned and brought to bottom within some seconds.
inline constexpr const char* short_well = R"(name = "short well"
[well]
measured_depth_m = [0, 60, 120, 400]
inclination_deg = [0, 0, 15, 15]
azimuth_deg = [0, 0, 0, 0]
bottom_depth_m = 150.6
top = "split"
[[hole]]
to_depth_m = 400
diameter_mm = 215.9
friction = 0.25
[[pipe]]
length_m = 110
outer_diameter_mm = 127
inner_diameter_mm = 108.61
segment_length_m = 10
[[pipe]]
length_m = 30
outer_diameter_mm = 165.1
inner_diameter_mm = 71.4375
segment_length_m = 10
[trip]
run_in_m = 10.5
speed_m_per_s = 5
ramp_s = 0.5
weight_on_bit_kN = 5
slack_off_m_per_s = 0.1
[top_drive]
rotation_rpm = 60
ramp_s = 1
[bit]
mass_kg = 65
friction_radius_mm = 60
[friction]
law = "smooth"
mu0 = 0.06
[drilling]
law = "root"
threshold_weight_kN = 1
[bit_rock]
stiffness_N_per_m = 1e8
damping_N_s_per_m = 1.5e5
[excitation]
source = "noise"
seed = 7
force_mean_kN = 2
force_deviation_kN = 1
torque_mean_N_m = 300
torque_deviation_N_m = 100
[run]
duration_s = 10
step_ms = 0.25
sample_ms = 5
[[stress_point]]
name = "in the \"build\" & <below>"
above_bit_m = 60
[[stress_point]]
name = "collar"
above_bit_m = 15
angle_deg = 90
)";

}  // namespace fmu_test
