#pragma once

#include <functional>
#include <string>
#include <vector>

#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"
#include "problem/initial_density.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::epc::half_plane {

/// Density and moments of a closure at one time.
struct ClosureSnapshot {
  double time;
  transform::SmoothDensity density;  ///< in the coordinates of the problem
  transform::Moments moments;        ///< in physical coordinates
};

/// Densities of a closure over time, and the status of the integration.
struct ClosureEvolution {
  std::vector<ClosureSnapshot> snapshots;
  transform::Status status = transform::Status::ok;
  std::string reason;
  long steps = 0;  ///< time steps of CVODE
  QuadraturePointCounts quadrature{};
  /// Largest change by more quadrature points: of the exponent Q_n, in standard deviations, or of
  /// the rates of the moments, in units of the frequency
  double quadrature_change = 0;
};

/// Initial density and times of an evolution.
struct EvolutionRequest {
  problem::InitialGaussian start;
  std::vector<double> times;  ///< increasing times; the first is 0
  /// Whether the densities are those of the periodic state, with the last time as period. The
  /// search for the periodic state begins at `start`.
  bool periodic = false;
};

/// Function that returns the density in y and v, with the factors of the formulation, of a closure.
using DensityOfClosure = std::function<transform::SmoothDensity(const ClosureDensity&)>;

/// Computes the density C exp(Q_n + confinement) over time by the exact moment equations
///
///     dm/dt = R(a(m)),   m = E[phi],   dR/dm = J M^-1,
///
/// with the residual R and its Jacobian J of GalerkinSystem and the covariance matrix M of the
/// basis functions phi. The density with the moments m has the maximum entropy: its coefficients
/// a(m) minimise the convex function ln Z(a) - a^T m with the Hessian matrix M. CVODE integrates
/// the moments instead of the coefficients, since the coefficients of a narrow density change
/// rapidly.
///
/// The confinement level is constant: the level of the stationary closure, but at most 6.5 standard
/// deviations of the velocity, and at least an energy that contains the initial density. The
/// initial density of the closure has the moments m of the initial Gaussian.
///
/// For a periodic state numerics::solve_fixed_point() finds the moments that return to themselves
/// at the last time.
///
/// The status is `inadmissible` if more than 1e-5 of the probability lies beyond 0.8 of the level
/// at a snapshot. No exponent Q_n that falls at infinity then has the moments, the density has a
/// maximum at the level, and the confinement determines the density (Junk, Math. Models Methods
/// Appl. Sci. 10 (2000) 1001). The status is `not_converged` if the integration fails, or if
/// additional quadrature points change the density.
/// @param options order n and tail of the closure
ClosureEvolution solve_evolution(const ClosureFormulation& formulation,
                                 const problem::Problem& problem, const Options& options,
                                 const EvolutionRequest& request,
                                 const DensityOfClosure& density_of);

}  // namespace fpkcheck::epc::half_plane
