#pragma once

#include <span>

#include "methods/external/external_density.hpp"

namespace fpkcheck::methods {

/// A method whose solution is a histogram of samples over the cells of the comparison axes. The
/// confidence intervals (95 %) and the sampling errors are those of independent samples. Samples at
/// rest in contact with a wall (y' = 0 at the wall) contribute to the moments but not to the
/// histogram, since the stationary law has an atom at that state.
/// @param y, v displacement and velocity of each sample
/// @param independent effective number of independent samples; 0 for the number of samples
/// @throws InputError when there are fewer than 100 samples, when y and v have different lengths,
///         when a value is not finite, or when `independent` exceeds the number of samples. The
///         member `check` of the method throws InputError when a sample is behind a wall
Method make_method_from_samples(const ExternalDensity& external, std::span<const double> y,
                                std::span<const double> v, double independent = 0);

}  // namespace fpkcheck::methods
