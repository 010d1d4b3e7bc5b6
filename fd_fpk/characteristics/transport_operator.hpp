#pragma once

#include <Eigen/Core>
#include <array>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of the density inside cells. For a density p + p_y (y - y_c) + p_v (v - v_c) in a cell
/// the two slopes are the area of the cell times p_y, and the area of the cell times p_v.
struct CellSlopes {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs the slopes of the density inside the cells from the masses of the cells, by central
/// differences of the densities in the neighbouring cells; at a wall the differences are one-sided.
/// The reconstruction is linear in the masses. The slopes are zero in the cells of rest points and
/// at ends of the axes that are not walls. Masses at rest in contact, which the vector stores after
/// the masses of the cells, have no slopes.
class SlopeReconstruction {
 public:
  /// @param points rest points, in whose cells the slopes are zero
  SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points);

  CellSlopes operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd v_slopes(const Eigen::VectorXd& masses) const;

  /// Sets a limiting factor for the slopes of each cell, such that the density reconstructed from
  /// the given masses is nonnegative inside the cell. The limiting factor is 1 if no limit is
  /// needed. All later reconstructions use the same limiting factors, so that the reconstruction
  /// remains linear.
  void set_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights by which the masses of the lower neighbour, the cell and the upper neighbour contribute
  // to a slope.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> weights(const Axis& axis);

  const Grid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // whether the cell belongs to a rest point, for each cell
  Eigen::VectorXd limits_y_, limits_v_;
};

/// Sums of impact quantities over the impacts at one wall, per impulse of the excitation.
struct ImpactSums {
  /// Number of impacts. The infinitely many impacts of a cascade that ends at rest do not count.
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
/// visit. During the visit, the operator adds the fraction of the mass q of the cell that lies in
/// the strip of the characteristic, with the slopes of the cell. Mass that receives no impulse
/// during the visit enters the next visit. The transport operator is exact along the
/// characteristics and conserves mass.
///
/// The vectors of p and of q contain the masses on the cells, followed by one mass for each rest
/// point in contact. In p the last masses are at rest in contact. In q the last masses were at rest
/// in contact until the impulse set them in motion.
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
