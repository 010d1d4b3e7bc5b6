#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// Closure with exact moment equations: p(y, v) = C exp(Q_n(y, v)) between the walls (y >= 0 for
/// the paper's oscillator), with all monomials of degree 1 .. n. The density satisfies the moment
/// equations of the impact process for every polynomial of degree up to n. The series (15) is not
/// truncated, and the impact condition (2) is not approximated. The only approximation is the form
/// of the exponent.
namespace fpkcheck::epc::moment {

/// Solves the formulation `moment` for epc::solve(), with validated options. The status is
///  - ok if the density satisfies the equations, and on the edge of its support has decayed to
///    kEdgeDensityLimit of its peak. For oscillators other than the paper's, exp(Q_n) must also
///    have decayed to kLevelDensityLimit at the confinement level. half_plane::set_status() has
///    further conditions;
///  - inadmissible if the density of the root violates one of these conditions;
///  - not_converged if Newton's method and the homotopy failed, or if the quadrature did not
///    converge.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::moment
