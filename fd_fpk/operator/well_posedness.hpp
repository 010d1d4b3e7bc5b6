#pragma once

#include <string>

#include "fd_fpk/axis/excitation.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"

namespace fpkcheck::fd_fpk {

/// Result of the stability check of the discretised excitation.
struct WellPosednessCheck {
  /// Growth rate and wavenumber of the fastest growing wave; zero for equations that are well-posed
  /// for every cell width
  FastestGrowingWave growth{0, 0};
  /// Reason why the scheme is ill-posed, and a remedy; empty for a well-posed scheme
  std::string ill_posed_reason;
};
WellPosednessCheck check_well_posedness(const problem::Problem& problem,
                                        const FiniteVolumeOptions& options,
                                        const PlaneDiscretisation& discretisation);

/// Returns the fastest growing wave of the discrete excitation on velocity cells of the given
/// width.
FastestGrowingWave fastest_growing_wave(const problem::Problem& problem,
                                        const FiniteVolumeOptions& options, double cell_width);

}  // namespace fpkcheck::fd_fpk
