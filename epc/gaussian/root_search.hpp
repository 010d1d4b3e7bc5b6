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

/// Result of the search for a root of (23).
struct RootSearchResult {
  std::optional<Polynomial> root;  ///< Q_n of the root; empty if no root was found
  double residual = 0;    ///< residual of the root, or the smallest residual of all iterates
  double condition = 0;   ///< condition number of the Jacobian in the scaled unknowns
  int iterations = 0;     ///< number of Newton steps of all attempts together
  std::string failure;    ///< reason why no root was found, one sentence; else empty
  SolutionBranch branch;  ///< branch of solutions, if the search followed a branch
  /// Whether the first attempt of find_root(), the method of the paper, found a root.
  bool plain_newton_converges = false;
  /// Relative change of the scaled coefficients if the radius of the disc of JumpIntegralRemainder
  /// is smaller by one standard deviation. Only `kf` sets this value.
  std::optional<double> disc_sensitivity;
  std::optional<Polynomial> previous;  ///< Q_(n-2), root of the equations of order n-2, or empty
};

/// Searches for a root by the following attempts in turn, and returns the first root. Beyond n = 6
/// the search prefers the first root whose density decays on the edge of its support.
///  1. plain Newton steps from equivalent linearisation, as in the paper;
///  2. damped Newton steps from equivalent linearisation;
///  3. damped Newton steps from the root of order n-2;
///  4. the branch from the exact density under white noise with elastic impacts;
///  5. Newton's homotopy from the root of order n-2.
RootSearchResult find_root(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
