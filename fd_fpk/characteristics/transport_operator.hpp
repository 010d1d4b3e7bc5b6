#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/rest_points.hpp"

namespace fpkcheck::fd_fpk {

/// Slopes of the density inside cells. The density in a cell with the centre (y_c, v_c) is p + p_y
/// (y - y_c) + p_v (v - v_c), and the stored slopes are p_y and p_v times the cell area.
struct DensitySlopesInCells {
  Eigen::VectorXd y;
  Eigen::VectorXd v;
};

/// Reconstructs the slopes of the density inside cells from the masses of the cells, by central
/// differences, or one-sided differences at a wall. The slopes are linear functions of the masses.
/// The slopes of the density are zero in the innermost cells of rest points, and in cells at an end
/// of an axis that is not a wall. Masses at rest in contact, stored after the masses of the cells,
/// have no slopes.
class DensitySlopeReconstruction {
 public:
  /// @param points rest points of the motion; the slopes are zero in the innermost cells around
  /// these rest points
  DensitySlopeReconstruction(const PhasePlaneGrid& grid, const std::vector<RestPoint>& points);

  DensitySlopesInCells operator()(const Eigen::VectorXd& masses) const;
  Eigen::VectorXd density_velocity_slopes(const Eigen::VectorXd& masses) const;

  /// Sets a limiting factor for the slopes of each cell, such that the density reconstructed from
  /// the given masses is nonnegative. All later reconstructions of slopes use the same limiting
  /// factors, so that the slopes remain linear functions of the masses.
  void set_slope_limiter(const Eigen::VectorXd& masses);

 private:
  // Weights of the masses of a cell and of its lower and upper neighbour in the slope of the
  // density in the cell.
  struct Weights {
    double below, centre, above;
  };
  static std::vector<Weights> slope_difference_weights(const GridAxis& axis);

  const PhasePlaneGrid& grid_;
  std::vector<Weights> of_y_, of_v_;
  std::vector<bool> at_rest_;  // whether each cell belongs to a rest point
  Eigen::VectorXd limits_y_, limits_v_;
};

/// Sums of impact quantities over the impacts at one wall, divided by the number of impulses.
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
/// impulses. With impulses at the constant rate lambda, the density p between impulses is also the
/// density just before the next impulse:
///
///     p = lambda int_0^infinity exp(-lambda t) (q transported along the motion for t) dt.
///
/// The transport operator follows the mass along the cell visits of each characteristic. In each
/// visited cell, the transport operator adds the part of the mass of q that lies in the strip of
/// the characteristic. Mass that receives no impulse during a cell visit enters the next visited
/// cell. The transport operator is exact along the characteristics and conserves mass.
///
/// Along a limit cycle a characteristic ends after several mean times between impulses. Mass that
/// reaches the end of a characteristic without an impulse is not part of the density p.
///
/// The vectors of the density p between impulses and of the density q after an impulse contain the
/// masses of the cells, followed by one mass for each rest point in contact with a wall. In the
/// vector of p the last masses are at rest in contact; in the vector of q the last masses were at
/// rest in contact until the impulse.
class TransportOperator {
 public:
  struct TransportedMasses {
    Eigen::VectorXd ended;  ///< masses of p, in the cells where the next impulse occurs
    /// Masses, by grid cell, that reach the end of a characteristic without an impulse
    Eigen::VectorXd continuing;
  };

  /// @param characteristics,law must outlive the transport operator
  TransportOperator(const Characteristics& characteristics, const problem::ImpulseLaw& law);

  /// @param masses masses of the density q after an impulse
  /// @param slopes slopes of the density q after an impulse inside cells
  /// @param impacts receives the sums of impact quantities over all impacts, if not null
  TransportedMasses operator()(const Eigen::VectorXd& masses, const DensitySlopesInCells& slopes,
                               ImpactSumsOfBothWalls* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<RestMassDistributionAfterImpulse> contact_impulse_distributions_;
  // The characteristics from the boundary are divided into parts with similar numbers of cell
  // visits, which the transport operator evaluates in parallel. Part k contains the characteristics
  // from part_bounds_[k] to part_bounds_[k + 1] - 1. The number of parts is independent of the
  // number of processors, so that sums over characteristics are reproducible.
  static constexpr std::size_t kParts = 2;
  std::array<std::size_t, kParts + 1> part_bounds_{};
};

}  // namespace fpkcheck::fd_fpk
