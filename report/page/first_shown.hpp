#pragma once

#include <set>
#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Ids of the solutions that a plot shows before anybody has chosen: those of the problem itself
/// (report/references.hpp) and the closest closure of each family; all that there are when that
/// leaves fewer than two.
std::set<std::string> first_shown(const results::Case& one);

}  // namespace fpkcheck::report
