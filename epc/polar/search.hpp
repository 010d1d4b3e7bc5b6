#pragma once

#include <functional>
#include <optional>
#include <string>

#include "epc/moment/newton.hpp"
#include "epc/polar/coordinates.hpp"
#include "epc/polar/equations.hpp"
#include "epc/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {

struct SearchOptions {
  int order;                 ///< n, 2 or more
  double tolerance = 1e-10;  ///< NewtonOptions::tolerance of the order asked for
  int max_iterations = 60;   ///< of Newton's method at each order
};

/// What was found.
struct Root {
  Polynomial q{{}};              ///< Q_n(rho, theta), without its constant
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double temperature = 0;        ///< E[v^2]
  double level = 0;              ///< energy of the confinement
  double level_density = 0;      ///< largest from there outwards, relative to the peak
  double support = 0;            ///< amplitude up to which the density is used
  QuadratureSize quadrature{};
  /// By how much the points mattered: the standard deviation of the last change of Q_n when half
  /// as many more were taken each way.
  double quadrature_change = 0;
  moment::NewtonResult newton;  ///< at the order asked for, or the one that failed; all iterations
  double condition = 0;
  /// Q_(n-2), up to a constant and to a rough tolerance; none for n = 2. Where
  /// it would rise it falls like a Gaussian.
  std::optional<std::function<double(double rho, double theta)>> previous;
  int homotopies = 0;   ///< how often damped Newton steps were lost and a homotopy was followed
  std::string failure;  ///< one sentence when there is no root
};

/// Follows the solution up the even orders, n - 2 to n, each with a domain from the density before.
Root find_root(const problem::Problem& problem, const Coordinates& coordinates,
               const SearchOptions& options);

}  // namespace fpkcheck::epc::polar
