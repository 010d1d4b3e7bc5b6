#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// The paper's closure: p(z, z') = C exp(Q_n) on the whole plane, its projections (23) under the
/// Gaussian weights (25)-(26).
namespace fpkcheck::epc::gaussian {

/// The formulation `gaussian` of epc::solve, options validated: solves (23) by find_root and judges
/// the root. The status is
///  - ok: the density is below kEdgeAllowed of its peak on the whole edge, its mass is within
///    kMassAllowed of 1, the stationary energy balance is met within kEnergyAllowed, and the root
///    is within kDistanceAllowed of that of order n-2 where the latter is a density;
///  - inadmissible: a root, but not such a density. Density and coefficients are still returned;
///  - not_converged: no root was found, or for `kf` none that stands on a plateau of the disc of
///    JumpRemainder; no density.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
