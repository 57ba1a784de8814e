// Calls of the FMU of a bit that have to be refused without harm, and what they say.
#include "tests/export/fmu_inputs.hpp"

using namespace bitrock;

namespace {

using namespace fmu_test;
using importer::Instance, importer::Outputs;

TEST_F(Fmu, AFailedCallSaysWhyAndChangesNothing) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(library.fmi2DoStep(instance.component, 0.0, 0.1, 0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, not_a_number, 0, 0.0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, 1.0, 1, 1.0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, 0.0, 1, 5.0), importer::ok);
  for (const auto& [reference, value] : {std::pair{9u, -1.0}, {10u, 0.0}, {11u, -1.0}, {12u, 2.01}, {10u, infinite}})
    EXPECT_EQ(instance.set_real(reference, value), importer::error) << reference;
  for (const auto& [reference, value] : {std::pair{13u, -1}, {14u, 0}, {14u, 3}, {15u, 3}, {15u, -2147483647 - 1}})
    EXPECT_EQ(instance.set_integer(reference, value), importer::error) << reference;
  ASSERT_EQ(library.fmi2EnterInitializationMode(instance.component), importer::ok);
  ASSERT_EQ(instance.set(10.0, 3e-3, 5e4), importer::ok);
  ASSERT_EQ(library.fmi2ExitInitializationMode(instance.component), importer::ok);
  run(instance, 0, 50, 0.03125);
  const double t = 50 * 0.03125;
  const std::vector<char> now = instance.state();
  instance.log.clear();

  const auto expect_error = [&](int status, const std::string& words) {
    EXPECT_EQ(status, importer::error) << words;
    EXPECT_NE(instance.log.find(words), std::string::npos) << instance.log << "\nlacks: " << words;
    EXPECT_EQ(instance.state(), now) << words;
    instance.log.clear();
  };
  for (const double bad : {not_a_number, infinite, -infinite}) {
    expect_error(instance.set(bad, 3e-3, 5e4), "rotation_rad_per_s: the value must be finite");
    expect_error(instance.set(11.0, bad, 5e4), "rate_of_penetration_m_per_s: the value must be finite");
    expect_error(instance.set(11.0, 2e-3, bad), "weight_on_bit_N: the value must be finite");
    expect_error(library.fmi2DoStep(instance.component, bad, 0.1, 0), "not finite");
    expect_error(library.fmi2DoStep(instance.component, t, bad, 0), "not finite");
  }
  expect_error(instance.step(t, t), "the step must be above 0");
  expect_error(instance.step(t, t - 0.1), "the step must be above 0");
  expect_error(instance.step(t - 0.03125, t), "must begin where the one before ended");
  expect_error(instance.step(t + 0.03125, t + 0.0625), "must begin where the one before ended");
  expect_error(instance.step(t, 5.001), "after the stop time");
  expect_error(library.fmi2DoStep(instance.component, t, 1e-20, 0), "too short");
  expect_error(instance.set_real(importer::torque, 1.0), "torque_N_m: an output cannot be set");
  expect_error(instance.set_real(9, 1.0), "threshold_weight_N: a parameter is fixed");
  expect_error(instance.set_real(999, 1.0), "(no such variable)");
  expect_error(instance.set_integer(importer::rotation, 1), "not a variable of this type");
  expect_error(library.fmi2ExitInitializationMode(instance.component), "not allowed in this phase");
  expect_error(library.fmi2SetReal(instance.component, nullptr, 1, nullptr), "null pointer");
  const unsigned none[1] = {0};
  int whole[1] = {0};
  double real[1] = {0.0};
  const char* text[1] = {""};
  expect_error(library.fmi2GetBoolean(instance.component, none, 1, whole), "no variables of this type");
  expect_error(library.fmi2SetString(instance.component, none, 1, text), "no variables of this type");
  expect_error(library.fmi2GetDirectionalDerivative(instance.component, none, 1, none, 1, real, real), "not provided");
  expect_error(library.fmi2SetRealInputDerivatives(instance.component, none, 1, whole, real), "no variables");
  expect_error(library.fmi2CancelStep(instance.component), "no step is pending");
  EXPECT_EQ(library.fmi2GetBoolean(instance.component, none, 0, whole), importer::ok);

  EXPECT_EQ(library.fmi2GetStatus(instance.component, 0, whole), importer::discard);
  EXPECT_EQ(library.fmi2GetIntegerStatus(instance.component, 0, whole), importer::discard);
  EXPECT_EQ(library.fmi2GetStringStatus(instance.component, 1, text), importer::discard);
  EXPECT_EQ(library.fmi2GetRealStatus(instance.component, 0, real), importer::discard);
  EXPECT_EQ(library.fmi2GetRealStatus(instance.component, 2, real), importer::ok);
  EXPECT_EQ(real[0], t);
  EXPECT_EQ(library.fmi2GetBooleanStatus(instance.component, 3, whole), importer::ok);
  EXPECT_EQ(whole[0], 0);

  EXPECT_EQ(run(instance, 50, 50, 0.03125).size(), 50U);  // it goes on
  ASSERT_EQ(library.fmi2Terminate(instance.component), importer::ok);
  EXPECT_EQ(instance.step(100 * 0.03125, 3.3), importer::error);
  EXPECT_EQ(library.fmi2DoStep(nullptr, 0.0, 0.1, 0), importer::error);
  library.fmi2FreeInstance(nullptr);
}

/// As importers in Python, Java or .NET: they cannot take variable arguments, and show the message as it is.
void take_plain(void* environment, const char*, int, const char*, const char* message, ...) {
  *static_cast<std::string*>(environment) += message;
}

TEST_F(Fmu, ItsMessagesAreWholeWithoutFurtherArguments) {
  std::string plain;
  const importer::Callbacks callbacks{take_plain, nullptr, nullptr, nullptr, &plain};
  const char* const location = "file:///no/such/100%25/%25s/resources";
  EXPECT_EQ(library.fmi2Instantiate("bit", 1, guid.c_str(), location, &callbacks, 0, 0), nullptr);
  EXPECT_NE(plain.find("fmi2Instantiate: "), std::string::npos) << plain;
  EXPECT_NE(plain.find("/no/such/100%%/%%s/resources"), std::string::npos) << plain;
  const Instance with_arguments(library, guid, location);
  EXPECT_NE(with_arguments.log.find("/no/such/100%/%s/resources"), std::string::npos) << with_arguments.log;
}

}  // namespace
