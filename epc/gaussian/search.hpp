#pragma once

#include <optional>
#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// What the search for a root of (23) came to.
struct Search {
  std::optional<Polynomial> root;  ///< Q_n
  double residual = 0;             ///< of the root, or the least one met
  double condition = 0;            ///< of the Jacobian at the root, in the scaled unknowns
  int iterations = 0;              ///< Newton steps, all attempts together
  std::string failure;             ///< one sentence when no root was found
  Branch branch;                   ///< when it was followed
  /// Whether the first of the ways below, the paper's, found a root.
  bool plain_newton_converges = false;
  /// For `kf`: the relative change of the scaled coefficients when the disc of JumpRemainder is a
  /// deviation smaller.
  std::optional<double> disc_sensitivity;
  std::optional<Polynomial> previous;  ///< Q_(n-2), a root of the equations of order n-2, if any
};

/// Looks for a root, in this order, and takes the first (beyond n = 6 the first whose density
/// decays on the edge of its support, if there is one):
///  1. plain Newton steps from equivalent linearisation, as in the paper;
///  2. damped ones;
///  3. damped ones from the root of order n-2;
///  4. the branch from the exact density without impact losses;
///  5. the equations of degree n added little by little to those of order n-2.
Search find_root(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
