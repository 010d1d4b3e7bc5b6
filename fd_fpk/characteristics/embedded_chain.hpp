#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/characteristics/transport_operator.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// A stationary law, as masses on cells and masses at rest in contact.
struct StationaryMasses {
  /// Masses of the density p on cells. The sum of these masses and of the masses in contact is 1.
  std::optional<Eigen::VectorXd> masses;
  /// Mass at rest, for each rest point: the mass in contact, or the mass in the cells of an
  /// equilibrium.
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
/// the velocity jumps J at fixed displacement. GMRES solves this equation twice: first with a
/// uniform density in each cell, which keeps the masses positive, then with slopes limited
/// according to the first solution. The preconditioner is the embedded chain aggregated to blocks
/// of cells.
/// @param deadline time limit for the construction of the characteristics and for GMRES
StationaryMasses stationary_masses(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Grid& grid,
                                   int characteristics_per_cell,
                                   const Deadline& deadline = Deadline::unlimited());

}  // namespace fpkcheck::fd_fpk
