#pragma once

#include <span>

#include "methods/external/external_density.hpp"

namespace fpkcheck::methods {

/// Returns a method whose solution is a histogram of samples over the comparison bins. The 95 %
/// confidence intervals and the sampling errors assume independent samples. Samples at rest in
/// contact with a wall (y' = 0 at the wall) contribute only to the moments, since the stationary
/// distribution has an atom at the state of rest.
/// @param y, v displacement and velocity of each sample
/// @param independent effective number of independent samples; 0 for the number of samples
/// @throws InputError for fewer than 100 samples, different lengths of y and v, a value that is not
/// finite, or `independent` above the number of samples. Method::check throws InputError for a
/// sample behind a wall.
Method make_method_from_samples(const ExternalDensity& external, std::span<const double> y,
                                std::span<const double> v, double independent = 0);

}  // namespace fpkcheck::methods
