#pragma once

#include <vector>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "numerics/interval/enclosure.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Computing times of the three stages of compute_bounds_on_grid(), and the residuals of the
/// certificates from which the bounds follow.
struct SplineGridDiagnostics {
  int unknown_count = 0;         ///< number of unknown spline coefficients of a certificate
  double enclosure_seconds = 0;  ///< wall-clock time to enclose the factors of the generator
  double fit_seconds = 0;        ///< wall-clock time of the least-squares fit of all certificates
  double verification_seconds = 0;  ///< wall-clock time to bound the residuals of all certificates

  /// Weighted residual (f + L V - U)/tau of the certificate V of a functional with the integrand f,
  /// the approximate mean U, the weight tau (ResidualWeightFunctionOfEnergy) and the generator L.
  struct FunctionalResidual {
    double approximate_mean;      ///< approximate mean U of the integrand f
    double least_residual;        ///< lower bound of the weighted residual inside the box
    double largest_residual;      ///< upper bound of the weighted residual inside the box
    double outer_residual_bound;  ///< upper bound of |f + L V - U|/tau outside the box
    long box_count;               ///< number of sub-boxes in the bisection of the box
  };
  std::vector<FunctionalResidual> functional_residuals;  ///< one element for each functional
};

/// Computes guaranteed bounds of functionals from certificates on one spline grid. The certificates
/// V of the bounds of all functionals are fitted together by least squares. The residual range of
/// each certificate gives the bounds U + least E[tau] <= E[f] <= U + largest E[tau].
/// @param weight weight tau of the residuals
/// @param threads number of threads, which does not change the bounds
/// @param diagnostics if not null, receives the computing times and the residuals
/// @return one enclosure for each functional, in the order of `functionals`
/// @throws LeastSquaresFitFailure (backward/generator/normal_equations.hpp)
std::vector<numerics::Enclosure> compute_bounds_on_grid(
    const problem::Problem& problem, const ResidualWeightFunctionOfEnergy& weight,
    const SplineGrid& grid, const std::vector<StationaryFunctional>& functionals, int threads,
    SplineGridDiagnostics* diagnostics = nullptr);

}  // namespace fpkcheck::backward
