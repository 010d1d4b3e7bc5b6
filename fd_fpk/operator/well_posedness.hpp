#pragma once

#include <string>

#include "fd_fpk/axis/growth_rate.hpp"
#include "fd_fpk/operator/discretisation.hpp"

namespace fpkcheck::fd_fpk {

/// Result of the stability check of the discretised excitation.
struct WellPosedness {
  Growth growth{0, 0};  ///< largest_growth; zero for equations that are well-posed for any cells
  /// Why the scheme is ill-posed and what to do; empty when it is well-posed.
  std::string ill_posed_reason;
};
WellPosedness check_well_posedness(const problem::Problem& problem, const Options& options,
                                   const Discretisation& discretisation);

/// largest_growth of the excitation of the options on cells of this width.
Growth largest_growth(const problem::Problem& problem, const Options& options, double step);

}  // namespace fpkcheck::fd_fpk
