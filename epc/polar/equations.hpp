#pragma once

#include <vector>

#include "epc/moment/basis.hpp"
#include "epc/moment/confinement.hpp"
#include "epc/moment/galerkin.hpp"
#include "epc/polar/coordinates.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {

/// The Galerkin equations of the impact process whose members are the functions h_p(rho)
/// g_q(theta), 1 <= p + q <= n. Along a trajectory and through the impulses,
///
///     L*phi = rho' phi_rho + theta' phi_theta + lambda ( E[phi(y, v + Y)] - phi ),
///     rho'   = -c rho sin^2 + (w w' - F) sin,            F = k y + mu y^3,
///     theta' = -w' sin^2 - (F/w) cos^2 - c sin cos,      sin, cos of theta,
///
/// all bounded at the origin, where phi jumps: a member has a mean, and its mean a rate of change,
/// as that of a polynomial has. (White noise has no such equations: d^2 theta/dv^2 is not
/// integrable.) Among the members is rho^2/2, so that the balance of energy is met.
class Equations : public moment::Galerkin {
 public:
  /// @param basis of_y() and of_v() are polynomials of rho and of theta
  Equations(const problem::Problem& problem, const Coordinates& coordinates, double rho_max,
            const moment::Confinement& confinement, moment::Basis basis,
            const QuadratureSize& size);

  const moment::Basis& basis() const { return basis_; }
  const Points& points() const { return points_; }

 private:
  Equations(const problem::Problem& problem, const Coordinates& coordinates, double rho_max,
            const moment::Confinement& confinement, moment::Basis basis, Points points,
            int wall_points);

  moment::Basis basis_;
  Points points_;
};

/// Amplitudes below rho_max from which an impulse may stop the mass at the wall: there the mean
/// over an atom of the law jumps as phi does at the origin. None for a law with a density.
std::vector<double> breaks_of(const problem::ImpulseLaw& law, double rho_max);

/// The basis that is orthonormal under a mass at the points.
moment::Basis basis_of(int order, const Points& points, const Eigen::VectorXd& mass);

}  // namespace fpkcheck::epc::polar
