#pragma once

#include <span>

#include "methods/external/external_density.hpp"

namespace fpkcheck::methods {

/// A method whose solution is a histogram of samples over the cells of the comparison axes, with 95
/// % intervals and sampling errors of independent samples. Samples at rest in contact with a wall
/// (y' = 0 there) enter the moments only, since the law has an atom there.
/// @param y, v of each sample
/// @param independent the effective number of independent samples; 0 for their number
/// @throws InputError when there are fewer than 100 samples, when y and v differ in number or are
///         not finite, or when `independent` exceeds their number. The method's check throws when a
///         sample is behind a wall
Method make_samples_method(const ExternalDensity& external, std::span<const double> y,
                           std::span<const double> v, double independent = 0);

}  // namespace fpkcheck::methods
