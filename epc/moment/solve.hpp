#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// The closure between the walls, in the paper on the physical half-plane: p(y, v) =
/// C exp(Q_n(y, v)), y >= 0, with all monomials of degree 1 .. n, such that the exact moment
/// equations of the impact process hold for every polynomial of degree up to n. Neither the series
/// of (15) is cut nor the impact of (2) approximated; what is left is the shape of the exponent.
namespace fpkcheck::epc::moment {

/// The formulation `moment` of epc::solve, options validated. The status is
///  - ok: the equations are met by a density that has decayed to kEdgeAllowed of its peak on the
///    edge of its support, and that of exp(Q_n) at the confinement's level to kLevelDensityAllowed;
///  - inadmissible: they are met, but not by such a density;
///  - not_converged: Newton's method and the homotopy were lost, or the quadrature did not settle.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::moment
