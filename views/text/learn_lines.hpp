#pragma once
/// What `learn` tells: how well the force is known by now, and at the end what more time would buy.

#include <string>

#include "studies/learn/learn.hpp"

namespace bitrock::views {

/// How well an output is known: in percent of it, or as it is where it is a correlation.
std::string known_to(std::size_t output, double error);

/// After a batch: cuts, error of the force, time left.
std::string batch_line(const studies::LearnProgress& progress);

/// At the end: one sentence for each output, and what an hour more would give.
std::string learnt_lines(const studies::Learnt& learnt);

}  // namespace bitrock::views
