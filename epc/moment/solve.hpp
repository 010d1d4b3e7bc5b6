#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Closure with exact moment equations: p(y, v) = C exp(Q_n(y, v)) between the walls (y >= 0 in the
/// paper's class), with all monomials of degree 1 .. n. The moment equations of the impact process
/// hold for every polynomial of degree up to n. The series (15) is not truncated and the impact (2)
/// is not approximated. The only approximation is the form of the exponent.
namespace fpkcheck::epc::moment {

/// Formulation `moment` of epc::solve, with validated options. The status is
///  - ok: the density satisfies the equations and has decayed to kEdgeDensityLimit of its peak on
///    the edge of its support; beyond the paper's class also exp(Q_n) to kLevelDensityLimit at the
///    confinement level. half_plane::set_status has further conditions;
///  - inadmissible: the root has no such density;
///  - not_converged: Newton's method and the homotopy failed, or the quadrature did not converge.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::moment
