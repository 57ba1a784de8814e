#pragma once
/// One `[[pipe]]` of a drilling case: its keys and what may stand there.

#include <string>

#include "base/config.hpp"
#include "runtime/drillstring/chain.hpp"

namespace bitrock::runtime {

/// The keys that say all of a pipe.
base::Section describe(PipeSection& pipe);
/// The key that names a pipe of common size, of which the entry then says the length alone.
base::Section describe_size(std::string& size);

/// Entry `i` (0-based). Throws `InputError` for a name that no pipe has, and for diameters that cannot be.
PipeSection read_pipe(base::ConfigFile& file, int i);

}  // namespace bitrock::runtime
