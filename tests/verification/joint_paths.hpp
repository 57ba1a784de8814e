#pragma once
/// One test body, two paths: every test of joints in motion runs once on the path that the engine takes by itself and
/// once on the plain reference path, element by element.

#include <gtest/gtest.h>

#include <string>

#include "dem2d/step/world.hpp"

using namespace bitrock;

namespace verification {

class JointPaths : public testing::TestWithParam<bool> {
 protected:
  dem2d::World on_path(dem2d::World world) const {
    world.reference_path = GetParam();
    return world;
  }
};

inline std::string path_name(const testing::TestParamInfo<bool>& info) {
  return info.param ? "reference" : "fast";
}

}  // namespace verification
