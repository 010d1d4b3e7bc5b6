#pragma once

#include <functional>

#include "epc/form/closure_over_time.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc::half_plane {

/// Function that returns the (y, v) density of a closure, with the factors of the formulation.
using DensityOfClosure = std::function<transform::SmoothDensity(const ClosureDensity&)>;

/// Computes the density C exp(Q_n + confinement term) over time by the exact moment equations
///
///     dm/dt = R(a(m)),   m = E[phi],   dR/dm = J M^-1,
///
/// with the residual R and its Jacobian J of GalerkinSystem and the covariance matrix M of the
/// basis functions phi. The closure density with the moments m has the maximum entropy: its
/// coefficients a(m) minimise the convex function ln Z(a) - a^T m, where Z is the integral of the
/// density without C. CVODE integrates the moments of the closure instead of its coefficients,
/// since the coefficients of a narrow density change rapidly.
///
/// The confinement level is constant in time: the level of the stationary closure, but at most the
/// energy of 6.5 standard deviations of the velocity, and at least an energy that contains the
/// initial density. The initial closure density has the moments of the initial Gaussian density.
///
/// For a periodic excitation numerics::solve_fixed_point() finds the moments that return to the
/// same values after one period, the last time.
///
/// The status is `inadmissible` if at an output time more than 1e-5 of the probability lies at
/// energies above 0.8 of the confinement level. If no exponent Q_n that falls at infinity has the
/// required moments, the density has a maximum at the confinement level, which determines the
/// density (Junk, Math. Models Methods Appl. Sci. 10 (2000) 1001). The status is `not_converged` if
/// the integration in time fails, or if additional quadrature points change the density.
/// @param options order n and tail of the closure
ClosureEvolution solve_evolution(const ClosureFormulation& formulation,
                                 const problem::Problem& problem, const ClosureOptions& options,
                                 const EvolutionRequest& request,
                                 const DensityOfClosure& density_of);

}  // namespace fpkcheck::epc::half_plane
