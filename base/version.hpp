#pragma once
/// Version and commit that this build was made from. CMake writes their values at build time (cmake/commit.cmake), so
/// that they are those of the sources that were compiled, not of the day on which the build was configured.

namespace bitrock::base {

extern const char* const version;  ///< "0.2.0"
/// Twelve digits, with "-dirty" behind them when files differed from the commit; "unknown: ..." where nobody knows.
extern const char* const git_commit;

}  // namespace bitrock::base
