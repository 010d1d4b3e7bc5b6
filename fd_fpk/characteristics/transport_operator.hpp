#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of the density inside cells. For a density p + p_y (y - y_c) + p_v (v - v_c) in a cell
/// with the centre (y_c, v_c), the stored slopes are p_y and p_v times the cell area.
struct DensitySlopesInCells {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs the slopes of the density inside cells from the masses of the cells, by central
/// differences, or one-sided differences at a wall. The slopes are linear in the masses. The slopes
/// are zero in the cells of rest points, and in cells at an end of an axis that is not a wall.
/// Masses at rest in contact, stored after the masses of the cells, have no slopes.
class DensitySlopeReconstruction {
 public:
  /// @param points rest points, in whose cells the slopes are zero
  DensitySlopeReconstruction(const PhasePlaneGrid& grid, const std::vector<RestPoint>& points);

  DensitySlopesInCells operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd density_velocity_slopes(const Eigen::VectorXd& masses) const;

  /// Sets a limiting factor for the slopes of each cell, such that the density reconstructed from
  /// the given masses is nonnegative. All later reconstructions of slopes use these limiting
  /// factors, so that the slopes remain linear in the masses.
  void set_slope_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of the lower neighbour, the cell and the upper neighbour in a slope.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> slope_difference_weights(const GridAxis& axis);

  const PhasePlaneGrid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // whether each cell belongs to a rest point
  Eigen::VectorXd limits_y_, limits_v_;
};

/// Sums of impact quantities over the impacts at one wall, per impulse of the excitation.
struct WallImpactSums {
  /// Number of impacts, without the infinitely many impacts of a cascade that ends at rest
  double number = 0;
  double momentum = 0;
  double energy = 0;  ///< sum of the squared impact speeds, int |v|^3 p dv
};
struct ImpactSumsOfBothWalls {
  WallImpactSums left, right;
  WallImpactSums& impact_sums_at_wall(WallSide side) {
    return side == WallSide::left ? left : right;
  }
  const WallImpactSums& impact_sums_at_wall(WallSide side) const {
    return side == WallSide::left ? left : right;
  }
};

/// Transport operator p = T q, which maps the density q after an impulse to the density p between
/// impulses. The density p between impulses is also the density just before the next impulse, with
/// the impulse rate lambda:
///
///     p = lambda int_0^infinity exp(-lambda t) (q transported along the motion for t) dt.
///
/// The operator follows the mass along the cell visits of each characteristic. During a visit the
/// operator adds that part of the mass of q in the cell that lies in the strip of the
/// characteristic. Mass that receives no impulse during the visit enters the next visited cell. The
/// operator is exact along the characteristics and conserves mass.
///
/// Along a limit cycle a characteristic ends after several mean times between impulses. Mass that
/// reaches the end of a characteristic without an impulse is not part of the density p.
///
/// The vectors of p and of q contain the masses on the cells, followed by one mass for each rest
/// point in contact. In p the masses after those of the cells are at rest in contact. In q these
/// masses were at rest in contact until the impulse.
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
  TransportedMasses operator()(const Eigen::VectorXd& masses, const DensitySlopesInCells& slopes,
                               ImpactSumsOfBothWalls* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<RestMassDistributionAfterImpulse> contact_impulse_distributions_;
  // The characteristics from the boundary form parts with similar numbers of visits, which the
  // operator adds up in parallel. Part k contains the characteristics from part_bounds_[k] to
  // part_bounds_[k + 1] - 1. The number of parts does not depend on the number of processors, so
  // that sums over characteristics are reproducible.
  static constexpr std::size_t kParts = 2;
  std::array<std::size_t, kParts + 1> part_bounds_{};
};

}  // namespace fpkcheck::fd_fpk
