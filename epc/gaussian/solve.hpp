#pragma once

#include "epc/options.hpp"
#include "epc/summary.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

/// The paper's closure: p(z, z') = C exp(Q_n) on the whole plane, with the projections (23) under
/// the Gaussian weights (25)-(26).
namespace fpkcheck::epc::gaussian {

/// Solves the formulation `gaussian` for epc::solve(), with validated options: solves (23) by
/// find_root() and assesses the root. The status is
///  - ok if the density on the whole edge of its support is below kEdgeDensityLimit of its peak,
///    the mass is within kMassTolerance of 1, and the residual of the energy balance is below
///    kEnergyResidualLimit. If the density of order n-2 has decayed on its edge, the distance to
///    this density must also be below kOrderDistanceLimit;
///  - inadmissible if the density of the root violates one of these conditions. The result still
///    contains the density and the coefficients;
///  - not_converged if no root was found, or if for `kf` the root depends on the disc of
///    JumpIntegralRemainder. The result has no density.
Result solve(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::gaussian
