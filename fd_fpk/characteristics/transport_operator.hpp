#pragma once

#include <Eigen/Core>
#include <array>

#include "fd_fpk/characteristics/cell_slopes.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"

namespace fpkcheck::fd_fpk {

/// Sums over the impacts at one wall, per impulse.
struct ImpactSums {
  /// Number of impacts, without those of a cascade to rest, which are infinitely many.
  double number = 0;
  double momentum = 0;  ///< sum of the impact speeds
  double energy = 0;    ///< sum of v^2 over the impacts: int |v|^3 p dv
};
struct WallImpacts {
  ImpactSums left, right;
  ImpactSums& at(Side side) { return side == Side::left ? left : right; }
};

/// The transport operator p = T q. It maps the density q after an impulse to the density p between
/// impulses, which is also that of the state at the next impulse:
///
///     p = lambda int_0^infinity exp(-lambda t) (q transported along the motion for t) dt.
///
/// Each visit of a characteristic takes its fraction of the mass that starts in its cell, with the
/// cell's slopes, adds the mass from the preceding visit, and passes on the mass that no impulse
/// has ended. The transport is exact along the characteristics and conserves mass.
///
/// Both vectors contain the masses on the cells, followed by one mass for each rest point in
/// contact: for p the mass at rest there, for q the mass that an impulse has just set in motion
/// from there.
class TransportOperator {
 public:
  /// Both arguments must outlive the operator.
  TransportOperator(const Characteristics& characteristics, const problem::ImpulseLaw& law)
      : characteristics_(characteristics), emissions_(characteristics.emissions(law)) {}

  /// @param masses of q
  /// @param slopes of q
  Eigen::VectorXd operator()(const Eigen::VectorXd& masses, const CellSlopes& slopes,
                             WallImpacts* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<Emission> emissions_;
};

}  // namespace fpkcheck::fd_fpk
