#pragma once
/// Chapter on a folder of `learn`: how well its force is known, how that came with the cuts, what an hour more would
/// buy.

#include "report/page.hpp"
#include "studies/learn/learn.hpp"
#include "studies/learn/notebook.hpp"

namespace bitrock::views {

/// `data`: the cuts of the folder, one case each, in the order they were made. Nothing for less than two.
void add_learnt(report::Page& page, const surrogate::TrainingData& data, const studies::LearnNotebook& notebook);

}  // namespace bitrock::views
