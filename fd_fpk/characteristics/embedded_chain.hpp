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
/// cells. The coarse correction removes the error components that decay slowly, over many impulses
/// (aggregation and disaggregation of Markov chains: Koury, McAllister, Stewart, SIAM J. Alg. Disc.
/// Meth. 5, 164 (1984)). Each atom of the stationary law, that is, mass at rest in contact with a
/// wall, is a separate block of the aggregated chain. Vectors of masses contain the masses of all
/// grid cells, followed by the masses at rest in contact.
class MarkovChainAggregation {
 public:
  /// Divides the grid into at most `max_blocks` blocks of cells; the line v = 0 of zero velocity is
  /// a boundary between blocks.
  MarkovChainAggregation(const PhasePlaneGrid& grid, int atom_count, int max_blocks);

  const PhasePlaneGrid& coarse_grid_of_cell_blocks() const { return blocks_; }

  /// @param step function that applies one step of the embedded chain to the masses of the blocks
  void set_chain_of_cell_blocks(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// Sets the weights that distribute the mass of each block over the cells of the block, in
  /// proportion to the given masses of the cells.
  void set_disaggregation_weights(const Eigen::VectorXd& masses);

  /// Replaces the residual r of the linear system (1 - A + start 1^T) d = r, with the transition
  /// matrix A of the embedded Markov chain, by an approximate solution d. The solution for the
  /// blocks is distributed over the cells by the weights of set_disaggregation_weights(). The part
  /// of the residual r whose sum over each block of cells is zero is added to the solution d.
  void apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd sum_masses_over_blocks(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const PhasePlaneGrid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  PhasePlaneGrid blocks_;
  Eigen::VectorXd weights_;  // fraction of the mass of a block in each cell
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// Stationary distribution, as masses of the cells and masses at rest in contact.
struct StationaryCellMasses {
  /// Masses of the stationary density in the grid cells; the sum of these masses and of the masses
  /// at rest in contact is 1
  std::optional<Eigen::VectorXd> masses;
  /// Mass at each rest point: mass at rest in contact with a wall, or mass in the innermost cells
  /// around an equilibrium
  std::vector<double> at_rest = {};
  ImpactSumsOfBothWalls impacts = {};
  /// L1 norm of the residual of the equation q = J p + r of the embedded Markov chain, with the
  /// density q after an impulse normalised to mass 1
  double residual = 0;
  long iterations = 0;
  std::string failure = {};
  std::vector<RestPoint> rest = {};
  long visits = 0;  ///< number of cell visits of all characteristics
};

/// Solves the equation q = J p + r of the embedded Markov chain for the density q after an impulse,
/// where J is the operator of the velocity jumps. The transport operator divides the masses of q
/// into the masses p that receive an impulse and the masses r that continue from the end of a
/// characteristic (TransportedMasses); the masses r are negligible except along a limit cycle.
/// GMRES solves the equation of the embedded Markov chain twice. In the first solution of the
/// Markov chain the density is uniform in each cell, so that all masses are positive. In the second
/// solution of the Markov chain the density has a slope in each cell, limited by the first
/// solution. The preconditioner of GMRES is the Markov chain on blocks of cells.
/// @param deadline time limit for the construction of the characteristics and for GMRES
StationaryCellMasses stationary_cell_masses(
    const problem::Problem& problem, const problem::MotionScales& scales,
    const PhasePlaneGrid& grid, int characteristics_per_cell,
    const base::Deadline& deadline = base::Deadline::without_time_limit());

}  // namespace fpkcheck::fd_fpk
