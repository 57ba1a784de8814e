#pragma once
/// Numbers of training data that would be ordinary in another unit than that of their column: rakes in radians, depths
/// in metres, forces that were not divided by the width of the cutter. Each number alone may be; all rows together
/// hardly.

#include <string>
#include <vector>

#include "surrogate/train/data.hpp"

namespace bitrock::surrogate {

/// One sentence a column, with its range, what is ordinary, and the likely cause. A column is doubted only when all its
/// rows are beyond what is ordinary.
std::vector<std::string> unit_slips(const TrainingData& data);

}  // namespace bitrock::surrogate
