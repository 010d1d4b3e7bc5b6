#pragma once

#include <optional>
#include <string>

#include "epc/form/exponent_polynomial.hpp"
#include "epc/gaussian/projected_equations.hpp"
#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

struct ClosureRootSearchResult {
  std::optional<ExponentPolynomial> root;
  StandardDeviations sigma = {};  ///< deviations of the Gaussian weights
  double residual = 0;   ///< residual of the root, or the smallest residual of all iterates
  double condition = 0;  ///< condition number of the Jacobian in the scaled unknowns
  int iterations = 0;
  std::string failure;
  SolutionBranch branch;
  bool plain_newton_converges = false;
  /// Relative change of the scaled coefficients of Q_n when the disc of JumpIntegralRemainder is
  /// reduced in radius by one standard deviation; only for the equation `kf`.
  std::optional<double> disc_sensitivity;
  std::optional<ExponentPolynomial> previous;
};

/// Makes the projected equations (23) of a problem, with the basis that the problem needs and with
/// the terms by formulas.
/// @param sigma standard deviations of the Gaussian weights
ProjectedEquations make_projected_equations(const problem::Problem& problem,
                                            const ClosureOptions& options,
                                            const DensityEquationCoefficients& coefficients,
                                            const StandardDeviations& sigma);

/// Returns the reason why the quadrature does not resolve the formulas of force, noise or
/// restitution in the projected equations. The reason is an empty text without formulas, or if the
/// quadrature resolves the formulas.
std::string unresolved_formulas_reason(const ProjectedEquations& projection);

/// Searches for a root of the projected equations (23) of the paper and returns the root of the
/// first successful attempt. Above closure order 6 the root search prefers the first root whose
/// density decays on the edge of its support. The attempts are:
///  1. plain Newton steps from equivalent linearisation, as in the paper;
///  2. damped Newton steps from equivalent linearisation;
///  3. damped Newton steps from the root of closure order n-2;
///  4. the branch from the exact density under white noise with elastic impacts;
///  5. Newton's homotopy from the root of the projected equations of closure order n-2.
ClosureRootSearchResult find_closure_root(const problem::Problem& problem,
                                          const ClosureOptions& options);

}  // namespace fpkcheck::epc::gaussian
