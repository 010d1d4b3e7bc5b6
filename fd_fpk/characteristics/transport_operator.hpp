#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of the density inside cells. For a density p + p_y (y - y_c) + p_v (v - v_c) in a cell,
/// the slopes are p_y and p_v times the cell area.
struct CellSlopes {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs the slopes of the density inside cells from the masses of the cells, by central
/// differences, or one-sided differences at a wall. The reconstruction is linear in the masses. The
/// slopes are zero in the cells of rest points and at ends of the axes that are not walls. Masses
/// at rest in contact, stored after the masses of the cells, have no slopes.
class SlopeReconstruction {
 public:
  /// @param points rest points, in whose cells the slopes are zero
  SlopeReconstruction(const Grid& grid, const std::vector<RestPoint>& points);

  CellSlopes operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd velocity_slopes(const Eigen::VectorXd& masses) const;

  /// Sets a limiting factor for the slopes of each cell, such that the density reconstructed from
  /// the given masses is nonnegative. All later reconstructions use the same limiting factors, so
  /// that the reconstruction remains linear.
  void set_slope_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of the lower neighbour, the cell and the upper neighbour in a slope.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> slope_weights(const Axis& axis);

  const Grid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // whether each cell belongs to a rest point
  Eigen::VectorXd limits_y_, limits_v_;
};

/// Sums of impact quantities over the impacts at one wall, per impulse of the excitation.
struct ImpactSums {
  /// Number of impacts, without the infinitely many impacts of a cascade that ends at rest
  double number = 0;
  double momentum = 0;
  double energy = 0;  ///< sum of the squared impact speeds, int |v|^3 p dv
};
struct WallImpacts {
  ImpactSums left, right;
  ImpactSums& sums_at(WallSide side) { return side == WallSide::left ? left : right; }
  const ImpactSums& sums_at(WallSide side) const { return side == WallSide::left ? left : right; }
};

/// Transport operator p = T q, which maps the density q after an impulse to the density p between
/// impulses. The density p is also the density just before the next impulse:
///
///     p = lambda int_0^infinity exp(-lambda t) (q transported along the motion for t) dt.
///
/// The mass that enters a cell visit is the mass that left the preceding visit. During the visit
/// the operator adds that part of the mass of q in the cell that lies in the strip of the
/// characteristic. Mass that receives no impulse during the visit enters the next visit. The
/// operator is exact along the characteristics and conserves mass.
///
/// Along a limit cycle a characteristic ends after several mean times between impulses. Mass that
/// reaches this end without an impulse is not part of p.
///
/// The vectors of p and of q contain the masses on the cells, followed by one mass for each rest
/// point in contact. In p the last masses are at rest in contact. In q the last masses were at rest
/// in contact until the impulse.
class TransportOperator {
 public:
  struct TransportedMasses {
    Eigen::VectorXd ended;  ///< masses of p, in the cells where the next impulse occurs
    /// Masses that reach the end of a characteristic without an impulse, in the cells of the ends
    Eigen::VectorXd continuing;
  };

  /// @param characteristics,law must outlive the operator
  TransportOperator(const Characteristics& characteristics, const problem::ImpulseLaw& law);

  /// @param masses masses of the density q
  /// @param slopes slopes of the density q
  /// @param impacts receives the sums over the impacts, if not null
  TransportedMasses operator()(const Eigen::VectorXd& masses, const CellSlopes& slopes,
                               WallImpacts* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<ContactImpulseDistribution> contact_impulse_distributions_;
  // The characteristics from the boundary form parts with similar numbers of visits, which the
  // operator adds up in parallel. Part k contains the characteristics from part_bounds_[k] to
  // part_bounds_[k + 1] - 1. The number of parts does not depend on the number of processors, so
  // that the sums are reproducible.
  static constexpr std::size_t kParts = 2;
  std::array<std::size_t, kParts + 1> part_bounds_{};
};

}  // namespace fpkcheck::fd_fpk
