#pragma once

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// What the balance of power needs to know of a density on the physical half-plane.
struct EnergyTerms {
  double mean_velocity;         ///< E[y']
  double mean_square_velocity;  ///< E[y'^2]
  double impact_energy_flux;    ///< int_{v<0} |v|^3 p(0, v) dv
};

/// The two sides of the balance of power, per unit time. Their difference is dE/dt of the mean
/// energy E[v^2]/2 + E[U(y)], U the potential of System, at any time and for any of the equations.
struct Power {
  double input;       ///< lambda E[Y^2]/2 + lambda E[Y] E[v]
  double dissipated;  ///< c E[v^2] + kappa int_{v<0} |v|^3 p(0,v) dv, kappa as below
};
Power power(const Problem& problem, Impact impact, const EnergyTerms& terms);

/// Residual of the stationary balance of power, relative to the input,
///
///     lambda E[Y^2]/2 + lambda E[Y] E[v] = c E[v^2] + kappa int_{v<0} |v|^3 p(0,v) dv,
///
/// kappa = (1-r^2)/2, or 1-r for Impact::delta. Zero for an exact stationary density of any of the
/// equations `white`, `km4`, `kf`: the energy is quadratic in v, so only E[Y] and E[Y^2] enter.
double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms);

}  // namespace fpkcheck::problem
