#pragma once

#include <vector>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "numerics/interval/enclosure.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Wall-clock times of the stages of bounds_from_grid(), and the residual range of each functional.
struct SplineGridReport {
  int unknowns = 0;
  double table_seconds = 0, fit_seconds = 0, check_seconds = 0;
  struct FunctionalResidual {
    double mean;            ///< approximate mean U of the integrand f
    double least, largest;  ///< range of the residual (f + L V - U)/tau inside the box
    double outside;         ///< upper bound of the residual |f + L V - U|/tau outside the box
    long boxes;             ///< number of sub-boxes in the bisection
  };
  std::vector<FunctionalResidual> each;
};

std::vector<numerics::Enclosure> bounds_from_grid(const problem::Problem& problem,
                                                  const ResidualWeight& weight,
                                                  const SplineGrid& grid,
                                                  const std::vector<Functional>& functionals,
                                                  int threads, SplineGridReport* report = nullptr);

}  // namespace fpkcheck::backward
