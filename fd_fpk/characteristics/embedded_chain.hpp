#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/characteristics/transport_operator.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// A stationary density as masses on cells and masses at rest in contact.
struct StationaryMasses {
  /// Masses of p on cells; their sum with the masses in contact is 1.
  std::optional<Eigen::VectorXd> masses;
  /// Masses at rest, for each rest point: in contact, or in the cells of an equilibrium.
  std::vector<double> at_rest = {};
  WallImpacts impacts = {};
  double residual = 0;  ///< ||J T q - q||_1 of the density q after impulses, normalised to mass 1
  long iterations = 0;  ///< iterations of GMRES
  std::string failure = {};
  std::vector<RestPoint> rest = {};  ///< rest points of the characteristics
  long visits = 0;                   ///< number of cell visits of all characteristics
};

/// The embedded Markov chain of states after impulses, q = J T q, with the transport operator T and
/// the velocity jumps J at fixed displacement. GMRES solves it twice: first with uniform mass in
/// each cell, which keeps the masses positive, then with slopes limited by that solution. The
/// preconditioner is the same chain on blocks of cells.
/// @param deadline time limit of the characteristics and of GMRES
StationaryMasses stationary_masses(const problem::Problem& problem, const problem::Scales& scales,
                                   const Grid& grid, int characteristics_per_cell,
                                   const Deadline& deadline = Deadline::none());

}  // namespace fpkcheck::fd_fpk
