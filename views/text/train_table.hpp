#pragma once
/// What `train` tells of the networks.

#include <string>

#include "surrogate/train/search.hpp"

namespace bitrock::views {

/// The errors of all kinds of networks that were compared, a row a kind, and which one was chosen.
std::string search_table(const surrogate::Search& search);

/// How well the networks know the cases they learnt from, and those they did not; a row a network.
std::string training_table(const surrogate::Model& model);

}  // namespace bitrock::views
