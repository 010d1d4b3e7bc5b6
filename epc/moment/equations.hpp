#pragma once

#include <vector>

#include <Eigen/Dense>

#include "epc/moment/basis.hpp"
#include "epc/moment/confinement.hpp"
#include "epc/moment/energy_domain.hpp"
#include "epc/moment/galerkin.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::moment {

/// How many points the rules have: of EnergyDomain::rule, and on the wall.
struct QuadratureSize {
  int y, v, wall;
};

/// The exact moment equations of the impact system: Galerkin equations whose members are the
/// polynomials of the basis, with
///
///     L*phi = v phi_y - (c v + k y + mu y^3) phi_v + sum_{j=1}^n lambda E[Y^j]/j! d^j phi/dv^j.
///
/// Nothing is cut off, since phi is a polynomial; there is no delta function and no weight.
class Equations : public Galerkin {
 public:
  /// @param rate_moment lambda E[Y^j] for j = 0 .. n (0 and those that the excitation lacks unused)
  Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
            const EnergyDomain& domain, const Confinement& confinement, Basis basis,
            const QuadratureSize& size);

  const Basis& basis() const { return basis_; }
  const Points& points() const { return inside_; }

 private:
  Equations(const problem::Problem& problem, const std::vector<double>& rate_moment,
            const EnergyDomain& domain, const Confinement& confinement, Basis basis,
            const Points& inside, const Points& wall);

  Basis basis_;
  Points inside_;
};

}  // namespace fpkcheck::epc::moment
