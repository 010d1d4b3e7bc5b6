#pragma once

#include <Eigen/Core>
#include <array>

#include "fd_fpk/characteristics/cell_slopes.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"

namespace fpkcheck::fd_fpk {

/// Sums over the impacts at one wall, per impulse of the excitation.
struct ImpactSums {
  /// Number of impacts. The infinitely many impacts of a cascade to rest are not counted.
  double number = 0;
  double momentum = 0;  ///< sum of the impact speeds
  double energy = 0;    ///< sum of the squared impact speeds: int |v|^3 p dv
};
struct WallImpacts {
  ImpactSums left, right;
  ImpactSums& sums_at(WallSide side) { return side == WallSide::left ? left : right; }
};

/// The transport operator p = T q. T maps the density q of the state after an impulse to the
/// density p of the state between impulses, which is also the density of the state just before the
/// next impulse:
///
///     p = lambda int_0^infinity exp(-lambda t) (q transported along the motion for t) dt.
///
/// Along a characteristic, the mass that enters a cell visit is the mass that left the preceding
/// visit. During the visit, the fraction of the mass q in the cell that belongs to the strip is
/// added, with the slopes of the cell. The mass to which no impulse occurs during the visit enters
/// the next visit. The transport is exact along the characteristics and conserves mass.
///
/// The vectors of p and of q contain the masses on the cells, followed by one mass for each rest
/// point in contact. For p this mass is at rest in contact. For q this mass was at rest in contact
/// until the impulse set it in motion.
class TransportOperator {
 public:
  /// @param characteristics,law must outlive the operator
  TransportOperator(const Characteristics& characteristics, const problem::ImpulseLaw& law)
      : characteristics_(characteristics),
        departures_from_contacts_(characteristics.departures_from_contacts(law)) {}

  /// @param masses of the density q
  /// @param slopes of q
  Eigen::VectorXd operator()(const Eigen::VectorXd& masses, const CellSlopes& slopes,
                             WallImpacts* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<ContactDepartures> departures_from_contacts_;
};

}  // namespace fpkcheck::fd_fpk
