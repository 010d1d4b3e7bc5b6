#pragma once

#include <cmath>

#include "epc/amplitude/half_circle.hpp"
#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/root_search_result.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::contact {

/// Searches for the root by half_plane::find_root() in the coordinates amplitude and velocity.
half_plane::RootSearchResult find_root(const problem::Problem& problem,
                                       const Coordinates& coordinates, const Options& options);

/// Function of amplitude and phase that evaluates Q_n, a polynomial of rho and v. The returned
/// function keeps a reference to q.
inline amplitude::PolarExponent polar_exponent(const Polynomial& q) {
  return [&q](double rho, double theta) { return q(rho, rho * std::sin(theta)); };
}

}  // namespace fpkcheck::epc::contact
