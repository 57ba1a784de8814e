#include "base/errors.hpp"

#include "base/text.hpp"

namespace bitrock::base {

InputError::InputError(const std::string& message) : std::runtime_error(printable(message)) {}
SimulationError::SimulationError(const std::string& message) : std::runtime_error(printable(message)) {}

}  // namespace bitrock::base
