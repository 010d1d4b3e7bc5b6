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

struct RootSearchResult {
  std::optional<Polynomial> root;
  StandardDeviations sigma = {};  ///< deviations of the Gaussian weights
  double residual = 0;   ///< residual of the root, or the smallest residual of all iterates
  double condition = 0;  ///< condition number of the Jacobian in the scaled unknowns
  int iterations = 0;
  std::string failure;
  SolutionBranch branch;
  bool plain_newton_converges = false;
  /// Relative change of the scaled coefficients if the disc of JumpIntegralRemainder is reduced in
  /// radius by one standard deviation; only for `kf`.
  std::optional<double> disc_sensitivity;
  std::optional<Polynomial> previous;
};

/// Searches for a root of the projected equations (23) and returns the root of the first successful
/// attempt. Beyond order n = 6 the first root whose density decays on the edge of the support is
/// preferred. The attempts are:
///  1. plain Newton steps from equivalent linearisation, as in the paper;
///  2. damped Newton steps from equivalent linearisation;
///  3. damped Newton steps from the root of order n-2;
///  4. the branch from the exact density under white noise with elastic impacts;
///  5. Newton's homotopy from the root of order n-2.
RootSearchResult find_root(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
