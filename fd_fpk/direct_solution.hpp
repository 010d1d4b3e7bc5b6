#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "fd_fpk/discretisation.hpp"
#include "fd_fpk/operator.hpp"
#include "fd_fpk/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// An operator on its grid with its null vector.
struct DirectSolution {
  Discretisation discretisation;
  SparseColumns matrix = {};
  std::optional<Eigen::VectorXd> averages = {};  ///< mass 1
  std::string failure = {};                      ///< why there are no averages, and what to do
};

/// The direct solution in a box whose walls carry no density, as far as the options leave the box
/// free: a wall with more than 1e-6 of the peak moves out by a quarter as long as that at least
/// halves the density on it.
DirectSolution solve_in_wide_enough_box(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::fd_fpk
