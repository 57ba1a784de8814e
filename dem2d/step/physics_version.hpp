#pragma once
/// The version of the engine's physics. It is part of the hash of every cut (files/run_file.hpp) and of the inputs of
/// every calibration journal, so that what an older engine has computed does not count as done.

namespace bitrock::dem2d {

/// Raised by hand whenever a change of the engine changes a bit of a force or of a crack;
/// tests/regression/pinned_bits_test.cpp says when.
inline constexpr int physics_version = 5;

}  // namespace bitrock::dem2d
