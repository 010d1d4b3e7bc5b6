#pragma once

#include "epc/amplitude/half_circle.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"
#include "epc/polar/coordinates.hpp"

namespace fpkcheck::epc::polar {

/// half_plane::find_root in amplitude and phase (amplitude::ClosureFormulation).
half_plane::Root find_root(const problem::Problem& problem, const Coordinates& coordinates,
                           const Options& options);

/// Q_n, a polynomial of rho and theta, as a function of both. The result refers to q.
inline amplitude::Exponent polar_exponent(const Polynomial& q) {
  return [&q](double rho, double theta) { return q(rho, theta); };
}

}  // namespace fpkcheck::epc::polar
