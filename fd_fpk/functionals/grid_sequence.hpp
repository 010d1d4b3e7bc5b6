#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "base/process/stopwatch.hpp"
#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Values of functionals, computed on a sequence of grids.
struct ConvergedValues {
  Eigen::VectorXd values = {};  ///< values on the finest grid; empty without a solution
  Eigen::VectorXd errors = {};  ///< estimated discretisation errors of the values
  double observed_order = 0;
  int nx = 0, nv = 0;        ///< numbers of cells of the finest grid
  bool reached = false;      ///< whether all errors are within the tolerance
  std::string failure = {};  ///< reason why there are no values, or why the tolerance is missed
};

/// Values on one grid.
struct LevelValues {
  Eigen::VectorXd values = {};
  int nx = 0, nv = 0;
  std::string failure = {};  ///< reason why `values` is empty
};

/// Function that returns the magnitudes of values, to which the tolerance is relative.
using Magnitudes = std::function<Eigen::VectorXd(const Eigen::VectorXd& values)>;

/// Computes functionals on grids whose cells become narrower by transform::kRefinementRatio, on three
/// grids at least if the time limit permits. The errors follow from the differences between the last
/// three grids, as in transform/richardson.hpp. The first two grids are solved in parallel.
/// @param evaluate function that computes the values on the grid with automatic cells divided by
/// `refinement`; two threads may call it at the same time
/// @param order order of the scheme
/// @param tolerance relative error at which no finer grid is tried
ConvergedValues converge_on_grids(const std::function<LevelValues(double refinement)>& evaluate,
                                  int order, double tolerance, const Magnitudes& magnitudes,
                                  const base::Deadline& deadline);

/// Function that computes the values from the stationary solution on one grid. If its result is
/// empty, it has stored a reason in `failure`.
using StationaryFunctionals = std::function<Eigen::VectorXd(
    DirectSolution& on, const base::Deadline& deadline, std::string& failure)>;

/// Computes functionals of the generator and of the stationary density by converge_on_grids().
/// @pre unsupported_reason() and transient_unsupported_reason() are empty
ConvergedValues converge_on_grids(const problem::Problem& problem, const Options& options,
                                  double tolerance, const StationaryFunctionals& functionals,
                                  const Magnitudes& magnitudes);

}  // namespace fpkcheck::fd_fpk
