#pragma once

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The expectations of a density that enter the balance of power.
struct EnergyTerms {
  double mean_velocity;            ///< E[y']
  double mean_square_velocity;     ///< E[y'^2]
  double impact_energy_flux;       ///< int_{v<0} |v|^3 p(a, v) dv at a left wall a
  double right_energy_flux = 0;    ///< int_{v>0} v^3 p(b, v) dv at a right wall b
  double mean_damping_power = {};  ///< E[y' f(y, y')]; unused where f = c y'
};

/// The two sides of the balance of power, per unit time. Their difference is dE/dt of the mean
/// energy E[v^2]/2 + E[U(y)], U the potential of System, at any time and for each equation.
struct Power {
  double input;       ///< D + lambda E[Y^2]/2 + lambda E[Y] E[v]
  double dissipated;  ///< E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv, likewise at b; kappa as below
};
Power power(const Problem& problem, Impact impact, const EnergyTerms& terms);

/// Residual of the stationary balance of power, relative to the input,
///
///     D + lambda E[Y^2]/2 + lambda E[Y] E[v] = E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv + ..,
///
/// kappa = (1-r^2)/2, or 1-r for Impact::delta. Zero for the exact stationary density of each of
/// the equations `white`, `km4`, `kf`: the energy is quadratic in v, so that only E[Y] and E[Y^2]
/// enter.
double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms);

}  // namespace fpkcheck::problem
