#pragma once

#include <string>

#include "fd_fpk/line/growth.hpp"
#include "fd_fpk/operator/discretisation.hpp"

namespace fpkcheck::fd_fpk {

/// Whether the excitation as discretised grows.
struct Posedness {
  Growth growth{0, 0};    ///< largest_growth; zero for the equations that cannot grow
  std::string objection;  ///< why it is ill-posed and what to do; empty when it is not
};
Posedness posedness(const problem::Problem& problem, const Options& options,
                    const Discretisation& discretisation);

/// largest_growth of the excitation that the options ask for on cells of this width.
Growth largest_growth(const problem::Problem& problem, const Options& options, double step);

}  // namespace fpkcheck::fd_fpk
