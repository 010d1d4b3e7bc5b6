#pragma once

#include <span>

#include "methods/external/own_density.hpp"

namespace fpkcheck::methods {

/// Samples, as a histogram over the cells of the comparison axes, with 95 % intervals and the
/// errors by chance that are those of independent ones.
/// @param y, v of each sample
/// @param independent how many independent ones they are worth; 0: all of them
/// Those at rest in contact with a wall, y' = 0 there, are in moments alone: the law has an atom.
/// @throws InputError when they are fewer than 100, of different numbers or not finite; when more
///         are said to be independent than there are. The method's check: when one is behind a wall
Method own_samples(const OwnDensity& own, std::span<const double> y, std::span<const double> v,
                   double independent = 0);

}  // namespace fpkcheck::methods
