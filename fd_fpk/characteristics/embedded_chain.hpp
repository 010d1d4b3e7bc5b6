#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/characteristics/passage.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::fd_fpk {

/// A stationary density as masses on cells, and in contact.
struct StationaryMasses {
  std::optional<Eigen::VectorXd> masses;  ///< of p, on cells; with those of `rest` they sum to 1
  std::vector<double> at_rest = {};  ///< in contact, or in the cells of an equilibrium, by place
  WallImpacts impacts = {};
  double residual = 0;  ///< ||J T q - q||_1 of the density after impulses, whose mass is 1
  long iterations = 0;  ///< of GMRES
  std::string failure = {};
  std::vector<RestPlace> rest = {};  ///< as the characteristics have them
  long visits = 0;                   ///< of cells by characteristics
};

/// The chain of the states right after impulses, q = J T q with the passage T and the jumps J of
/// the velocity at fixed displacement, solved by GMRES: first with the mass evenly spread in each
/// cell, which keeps it positive, then with tilts limited by that solution. GMRES is preconditioned by
/// the same chain on blocks of cells.
/// @param deadline at which characteristics and GMRES give up
StationaryMasses stationary_masses(const problem::Problem& problem, const problem::Scales& scales,
                                   const Grid& grid, int characteristics_per_cell,
                                   const Deadline& deadline = Deadline::none());

}  // namespace fpkcheck::fd_fpk
