#pragma once

#include <cmath>
#include <string>

#include "fd_fpk/linear/preconditioner.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "problem/case_file.hpp"

/// Common to the benchmarks: the paper's cases on grids of a given size.
namespace fpkcheck::benchmarks {

/// The paper's case with this number, 1 .. 4.
inline problem::Problem paper_case(long number) {
  return problem::load_case("case" + std::to_string(number));
}

/// Options of a direct solution of kf on about `unknowns` cells, in the automatic box, with the
/// ratio of 40 x 88 cells.
inline fd_fpk::FiniteVolumeOptions options_for(long unknowns) {
  const int nx = static_cast<int>(std::lround(std::sqrt(static_cast<double>(unknowns) / 2.2)));
  return {
      .stepper = fd_fpk::StationarySolver::direct, .nx = nx, .nv = 2 * static_cast<int>(1.1 * nx)};
}

/// Case 1 on a grid of about `unknowns` cells.
struct CaseOnGrid {
  problem::Problem problem = paper_case(1);
  fd_fpk::FiniteVolumeOptions options;
  fd_fpk::PlaneDiscretisation discretisation;

  explicit CaseOnGrid(long unknowns)
      : options(options_for(unknowns)),
        discretisation(fd_fpk::discretise_density_equation(
            problem, options, fd_fpk::initial_box(problem, options))) {}

  const fd_fpk::PhasePlaneGrid& grid() const { return discretisation.grid; }
  const fd_fpk::DiscretisedExcitation& excitation() const { return discretisation.excitation; }
  fd_fpk::FokkerPlanckOperator op() const {
    return fd_fpk::fokker_planck_operator(problem.system, excitation(), options.impact, grid(),
                                          fd_fpk::transport_order(options));
  }
  fd_fpk::Preconditioner preconditioner() const {
    return {problem, excitation(), options.impact, grid()};
  }
};

}  // namespace fpkcheck::benchmarks
