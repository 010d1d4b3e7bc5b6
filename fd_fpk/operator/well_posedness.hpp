#pragma once

#include <string>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/operator/discretisation.hpp"

namespace fpkcheck::fd_fpk {

/// Result of the stability check of the discretised excitation.
struct WellPosedness {
  /// the fastest growing wave; zero for equations that are well-posed with any cell width
  FastestGrowingWave growth{0, 0};
  /// The reason why the scheme is ill-posed, and what to do; empty if the scheme is well-posed.
  std::string ill_posed_reason;
};
WellPosedness check_well_posedness(const problem::Problem& problem, const Options& options,
                                   const Discretisation& discretisation);

/// The fastest growing wave of the excitation that the options select, on velocity cells of the
/// given width.
FastestGrowingWave fastest_growing_wave(const problem::Problem& problem, const Options& options,
                                        double cell_width);

}  // namespace fpkcheck::fd_fpk
