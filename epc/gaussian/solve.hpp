#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// The paper's closure: p(z, z') = C exp(Q_n) on the whole plane, with the projections (23) under
/// the Gaussian weights (25)-(26).
namespace fpkcheck::epc::gaussian {

/// Formulation `gaussian` of epc::solve, with validated options: solves (23) by find_root and
/// assesses the root. The status is
///  - ok: the density is below kEdgeDensityLimit of its peak on the whole edge, its mass is within
///    kMassTolerance of 1, and the residual of the energy balance is below kEnergyResidualLimit.
///    The distance to order n-2 is below kOrderDistanceLimit if order n-2 is a density;
///  - inadmissible: a root without such a density. Density and coefficients are still returned;
///  - not_converged: no root was found, or for `kf` the root depends on the disc of JumpRemainder.
///    There is no density.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
