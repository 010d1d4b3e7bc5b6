#pragma once

#include <vector>

#include "results/run.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of the problem itself, against which tables and sentences put all others: the
/// reference of the case first, then the rest in their order. None without a reference.
std::vector<const transform::Solution*> references(const results::Case& one);

}  // namespace fpkcheck::report
