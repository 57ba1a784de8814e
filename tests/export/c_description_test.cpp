// A bit as a C header (`bitrock export bit`): compiled by a C compiler and linked with libbitrock_runtime.so alone, it
// gives the force of `BitForce` to the last bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/source/c_description.hpp"
#include "surrogate/net/model_file.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

const std::string shipped = std::string(BITROCK_SOURCE_DIR) + "/campaigns/";

/// Asks two bits of one header, so that a name without its prefix is seen.
constexpr const char* program = R"c(
#include <stdio.h>
#include <stdlib.h>
#include "mine.h"
#include "other_name.h"
int main(void) {
  size_t bytes = 0;
  bitrock_core* core = NULL;
  if (bitrock_core_size(&mine_description, &bytes) != BITROCK_OK) return 1;
  if (other_name_description.cutter_count != mine_description.cutter_count) return 1;
  if (bitrock_core_create(malloc(bytes), bytes, &mine_description, &core) != BITROCK_OK) return 1;
  for (int i = 0; i < 400; ++i) {
    bitrock_load load;
    if (bitrock_core_update(core, 0.05 * i, 10.0, 0.004, &load) != BITROCK_OK) return 1;
    printf("%a %a\n", load.axial_force_N, load.torque_N_m);
  }
  return 0;
}
)c";

class CDescription : public ::testing::Test {
 protected:
  surrogate::Model model_ = surrogate::read_model(shipped + "paper240/model.json");
  runtime::Bit bit_ = runtime::read_bit(shipped + "bits/pdc15.toml");
};

TEST_F(CDescription, GivesTheForceOfBitForce) {
  const scratch::Folder folder("c_description");
  bit_.signal.seed = 0xffffffffffffffffULL;
  base::write_whole(folder / "mine.h", runtime::c_description(bit_, model_, "mine"));
  base::write_whole(folder / "other_name.h", runtime::c_description(bit_, model_, "other_name"));
  base::write_whole(folder / "program.c", program);
  const std::string library = BITROCK_RUNTIME_SHARED;
  const std::string compile = fmt::format(
      "cd '{0}' && {1} -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror -I'{2}' -I. program.c '{3}' -o program "
      "-Wl,-rpath,'{4}' && ./program >printed",
      folder.path().string(), BITROCK_C_COMPILER, BITROCK_SOURCE_DIR, library,
      std::filesystem::path(library).parent_path().string());
  ASSERT_EQ(std::system(compile.c_str()), 0);

  runtime::BitForce force(bit_, model_);
  std::istringstream printed(base::read_whole(folder / "printed"));
  double largest = 0.0;
  for (int i = 0; i < 400; ++i) {
    std::string axial, torque;
    ASSERT_TRUE(printed >> axial >> torque);
    const runtime::BitLoad load = force.at({.angle = 0.05 * i, .rotation = 10.0, .rate_of_penetration = 0.004});
    EXPECT_EQ(std::strtod(axial.c_str(), nullptr), load.axial_force) << "angle " << 0.05 * i;
    EXPECT_EQ(std::strtod(torque.c_str(), nullptr), load.torque) << "angle " << 0.05 * i;
    largest = std::max(largest, load.torque);
  }
  EXPECT_GT(largest, 0.0);
}

TEST_F(CDescription, RefusesWhatCannotBe) {
  EXPECT_THROW(runtime::c_description(bit_, model_, "my-bit"), base::InputError);
  bit_.cutters.clear();
  EXPECT_THROW(runtime::c_description(bit_, model_, "bit"), base::InputError);
}

/// No word of a bit's file ends the comment it stands in.
TEST_F(CDescription, NamesStayInTheirComment) {
  bit_.name = "mine */ int stray; /*";
  const std::string text = runtime::c_description(bit_, model_, "bit");
  EXPECT_EQ(text.find("*/ int stray"), std::string::npos);
}

}  // namespace
