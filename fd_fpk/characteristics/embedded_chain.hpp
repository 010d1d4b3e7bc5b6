#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/characteristics/transport_operator.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// Coarse correction for the embedded Markov chain on cells, by a chain on blocks of neighbouring
/// cells. The correction removes the slow error components, which decay over many impulses
/// (aggregation and disaggregation of Markov chains: Koury, McAllister, Stewart, SIAM J. Alg. Disc.
/// Meth. 5, 164 (1984)). Each atom at a rest point in contact is a block of its own. In all vectors
/// of masses the masses of the atoms follow the masses of the cells.
class Aggregation {
 public:
  /// Divides the grid into at most `max_blocks` blocks with about equal numbers of cells; the line
  /// v = 0 is a boundary between blocks.
  Aggregation(const Grid& grid, int atom_count, int max_blocks);

  /// The grid whose cells are the blocks.
  const Grid& block_grid() const { return blocks_; }

  /// @param step function that applies one step of the embedded chain to the masses of the blocks
  void set_block_chain(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step);
  /// Sets the weights that distribute the mass of a block over its cells. The weights are
  /// proportional to the given masses of the cells, and uniform in blocks whose masses are zero.
  void set_disaggregation_weights(const Eigen::VectorXd& masses);

  /// Replaces the residual r of (1 - A + start 1^T) d = r by an approximate d: the solution d of
  /// the equation for the blocks is distributed over the cells by the weights, and the part of r
  /// whose sum over each block is zero is added.
  void apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const;

 private:
  Eigen::VectorXd aggregate(const Eigen::Ref<const Eigen::VectorXd>& masses) const;

  const Grid& grid_;
  int atoms_;
  std::vector<int> block_of_y_, block_of_v_;
  Grid blocks_;
  Eigen::VectorXd weights_;  // for each cell, its fraction of the mass of its block
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// A stationary distribution, as masses of the cells and masses at rest in contact.
struct StationaryMasses {
  /// Masses of the density p on the cells of the grid. The masses of the cells and the masses at
  /// rest in contact sum to 1.
  std::optional<Eigen::VectorXd> masses;
  /// For each rest point the mass at rest: the mass in contact with the wall, or the mass in the
  /// innermost cells about an equilibrium.
  std::vector<double> at_rest = {};
  WallImpacts impacts = {};
  /// residual ||J T q - q||_1 of the density q after impulses, with q normalised to mass 1
  double residual = 0;
  long iterations = 0;  ///< iterations of GMRES
  std::string failure = {};
  std::vector<RestPoint> rest = {};  ///< rest points of the motion
  long visits = 0;                   ///< number of cell visits of all characteristics
};

/// The embedded Markov chain of states after impulses, q = J T q, with the transport operator T and
/// the velocity jumps J at fixed displacement. GMRES solves q = J T q twice: first with a uniform
/// density in each cell, which keeps the masses positive, then with slopes of the density in the
/// cells, limited according to the first solution. The preconditioner is the embedded chain
/// aggregated to blocks of cells.
/// @param deadline time limit for the construction of the characteristics and for GMRES
StationaryMasses stationary_masses(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Grid& grid,
                                   int characteristics_per_cell,
                                   const Deadline& deadline = Deadline::unlimited());

}  // namespace fpkcheck::fd_fpk
