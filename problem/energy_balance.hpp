#pragma once

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The expectations under a density that enter the balance of power.
struct EnergyTerms {
  double mean_velocity;            ///< E[y']
  double mean_square_velocity;     ///< E[y'^2]
  double impact_energy_flux;       ///< int_{v<0} |v|^3 p(a, v) dv at a left wall a
  double right_energy_flux = 0;    ///< int_{v>0} v^3 p(b, v) dv at a right wall b
  double mean_damping_power = {};  ///< E[y' f(y, y')]; not used if f = c y'
};

/// The two sides of the balance of power: mean energy input and dissipated energy, per unit time.
/// At any time and for each equation, input minus dissipated is the time derivative of the mean
/// energy E[v^2]/2 + E[U(y)], where U is the potential of System.
struct PowerBalance {
  double input;  ///< D + lambda E[Y^2]/2 + lambda E[Y] E[v]
  /// E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv, likewise at b; for kappa see energy_residual().
  double dissipated;
};
PowerBalance power_balance(const Problem& problem, Impact impact, const EnergyTerms& terms);

/// Residual of the stationary balance of power, divided by the input. The balance is
///
///     D + lambda E[Y^2]/2 + lambda E[Y] E[v] = E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv + ..,
///
/// with kappa = (1-r^2)/2, or kappa = 1-r for Impact::delta. The residual is zero for the exact
/// stationary density of each of the equations `white`, `km4` and `kf`, which agree in E[Y] and
/// E[Y^2]: the energy is quadratic in v, so that no higher moments of Y enter.
double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms);

}  // namespace fpkcheck::problem
