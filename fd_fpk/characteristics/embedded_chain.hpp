#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/transport_operator.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Coarse correction for the embedded Markov chain on cells, by a chain on blocks of neighbouring
/// cells. The correction removes the slow error components, which decay over many impulses
/// (aggregation and disaggregation of Markov chains: Koury, McAllister, Stewart, SIAM J. Alg. Disc.
/// Meth. 5, 164 (1984)). Each atom at a rest point in contact is a separate block. In all vectors
/// of masses the masses of the atoms follow the masses of the cells.
class ChainAggregation {
 public:
  /// Divides the grid into at most `max_blocks` blocks; the line v = 0 is a boundary between
  /// blocks.
  ChainAggregation(const Grid& grid, int atom_count, int max_blocks);

  const Grid& block_grid() const { return blocks_; }

  /// @param step function that applies one step of the embedded chain to the masses of the blocks
  void set_block_chain(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// Sets weights that distribute the mass of a block over the cells of the block in proportion to
  /// `masses`.
  void set_disaggregation_weights(const Eigen::VectorXd& masses);

  /// Replaces the residual r of (1 - A + start 1^T) d = r by an approximate solution d. The
  /// solution for the blocks is distributed over the cells by the weights. The part of the residual
  /// r whose sum over each block is zero is added to d.
  void apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd sum_over_blocks(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const Grid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  Grid blocks_;
  Eigen::VectorXd weights_;  // fraction of the mass of a block in each cell
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// Stationary distribution, as masses of the cells and masses at rest in contact.
struct StationaryMasses {
  /// Masses of the density p on the cells, which sum to 1 together with the masses at rest in
  /// contact
  std::optional<Eigen::VectorXd> masses;
  /// Mass at each rest point: in contact with the wall, or in the innermost cells of an equilibrium
  std::vector<double> at_rest = {};
  WallImpacts impacts = {};
  /// Residual ||J p + r - q||_1 of the chain, with q normalised to mass 1
  double residual = 0;
  long iterations = 0;
  std::string failure = {};
  std::vector<RestPoint> rest = {};
  long visits = 0;  ///< number of cell visits of all characteristics
};

/// Solves q = J p + r for the embedded Markov chain of states after impulses, with the velocity
/// jumps J. The transport operator divides the masses of q into the masses p that receive an impulse
/// and the masses r that continue from the end of a characteristic (TransportedMasses); r is
/// negligible except along a limit cycle. The equation is solved twice by GMRES. The first
/// discretisation has a uniform density in each cell, so that all masses are positive. The second
/// discretisation has slopes of the density in the cells, which the first solution limits. The
/// preconditioner is the embedded chain aggregated to blocks of cells.
/// @param deadline time limit for the construction of the characteristics and for GMRES
StationaryMasses stationary_masses(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Grid& grid,
                                   int characteristics_per_cell,
                                   const base::Deadline& deadline = base::Deadline::unlimited());

}  // namespace fpkcheck::fd_fpk
