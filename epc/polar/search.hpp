#pragma once

#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::epc::polar {

/// half_plane::find_root in amplitude and phase. The level lies where Q_n is far below its peak,
/// else beyond the amplitude at which it rises again; energies are rho^2/2.
half_plane::Root find_root(const problem::Problem& problem, const Coordinates& coordinates,
                           const Options& options);

/// The exponent of a density on the way: Q_n as far as it falls, and from there on a Gaussian.
double exponent(const half_plane::Shape& shape, double rho, double theta);

}  // namespace fpkcheck::epc::polar
