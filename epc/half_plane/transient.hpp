#pragma once

#include <functional>

#include "epc/form/closure_over_time.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc::half_plane {

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
                                 const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request,
                                 const DensityOfClosure& density_of);

}  // namespace fpkcheck::epc::half_plane
