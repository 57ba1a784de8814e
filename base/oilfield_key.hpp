#pragma once
/// A key has one unit, and some have a second one: who works in feet writes `length_ft` where another writes
/// `length_m`. The pairs of units stand here, once for all tables.

#include <optional>

#include "base/config.hpp"

namespace bitrock::base {

/// The field under its other key: name, factor and range are those of the unit of the oil field. Nothing where the
/// field does not allow it (`Field::oilfield`). Throws `std::logic_error` where the unit of the key has no partner.
std::optional<Field> in_oilfield_unit(const Field& field);

}  // namespace bitrock::base
