#pragma once

#include <span>

#include "methods/given/own_density.hpp"

namespace fpkcheck::methods {

/// Samples, as a histogram over the cells of the comparison axes, with 95 % intervals and the
/// errors by chance that are those of independent ones.
/// @param y, v of each sample
/// @param independent how many independent ones they are worth; 0: all of them
/// @throws InputError when they are fewer than 100, of different numbers, not finite, or behind the
///         wall; when more are said to be independent than there are
Method own_samples(const OwnDensity& own, std::span<const double> y, std::span<const double> v,
                   double independent = 0);

}  // namespace fpkcheck::methods
