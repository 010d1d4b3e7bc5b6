#pragma once

#include <optional>
#include <string>
#include <vector>

#include "epc/moment/confinement.hpp"
#include "epc/moment/energy_domain.hpp"
#include "epc/moment/equations.hpp"
#include "epc/moment/newton.hpp"
#include "epc/polynomial.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

struct SearchOptions {
  int order;                        ///< n, 2 or more
  std::vector<double> rate_moment;  ///< lambda E[Y^j], j = 0 .. n; those left out of it zero
  Tail tail = Tail::confined;
  double tolerance = 1e-10;  ///< NewtonOptions::tolerance of the order asked for
  int max_iterations = 60;   ///< of Newton's method at each order
  /// Largest density on the edge of the support, relative to the peak, that needs no other level.
  double edge_allowed = 1e-6;
};

/// A density C exp(Q_n + confinement).
struct Shape {
  Polynomial q{{}};              ///< Q_n in physical monomials, without its constant
  double log_normalisation = 0;  ///< ln of the integral of exp(Q_n + confinement)
  double peak = 0;               ///< largest exponent
  double temperature = 0;        ///< E[v^2]
  double level = 0;              ///< energy of the confinement or the cut
  double support = 0;            ///< energy up to which the density is used
};

/// What was found.
struct Root {
  Shape shape;
  std::optional<Shape> previous;  ///< of order n - 2, to a rough tolerance; none for n = 2
  double edge_density = 0;        ///< largest on the edge of the support, relative to the peak
  QuadratureSize quadrature{};
  /// By how much the points matter: the standard deviation of the change of Q_n that a Newton step
  /// on more than twice as many points would make.
  double quadrature_change = 0;
  NewtonResult newton;  ///< at the order asked for, or the one that failed; iterations in all
  double condition = 0;
  int homotopies = 0;   ///< how often damped Newton steps were lost and a homotopy was followed
  std::string failure;  ///< one sentence when there is no root
};

/// Follows the solution up the even orders, n - 2 to n, each with a domain from the density before.
Root find_root(const problem::Problem& problem, const SearchOptions& options);

}  // namespace fpkcheck::epc::moment
