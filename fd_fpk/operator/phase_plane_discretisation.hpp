#pragma once

#include <string>

#include "fd_fpk/operator/fokker_planck_operator.hpp"
#include "fd_fpk/options.hpp"
#include "fd_fpk/selection_policy.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Computational box of the phase plane in which the density is computed; each impact wall is an
/// end of the computational box.
struct PhasePlaneBox {
  double x1_max;
  double x2_max;
  double x1_min = 0;
  DensityLengthScales lengths =
      {};  ///< units of the cell widths; 0 selects standard deviations as units
};

/// Maximum number of cells of a grid. With the maximum number of cells, the factors of the
/// preconditioner and the vectors of GMRES take about two gigabytes of memory.
inline constexpr int kMaxCells = 100000;

struct PlaneDiscretisation {
  PhasePlaneGrid grid;
  DiscretisedExcitation excitation;
  /// regularisation length l of the truncated Kramers-Moyal equation `km4`; 0 for other equations
  double regularisation_length = 0;
  /// Reason why no grid exists, and a remedy; empty if a grid exists
  std::string failure = {};
  double cells = 0;  ///< number of cells of the grid; without a grid, the required number of cells
};

/// Returns the grid and the excitation discretised on the grid. The cell widths are about 1/7
/// (displacement x1) and 1/6 (velocity x2) of a standard deviation of the density, or of a length
/// scale of the computational box. On a graded grid the cells far from the origin are 1.6 times as
/// wide as the cells of a uniform grid. If the force has kinks in the displacement x1, the cells of
/// x1 are narrower where the stiffness of the spring is larger.
PlaneDiscretisation discretise_density_equation(const problem::Problem& problem,
                                                const FiniteVolumeOptions& options,
                                                const PhasePlaneBox& box);

/// Computational box of the phase plane, with the numbers of grid cells in x1 and x2.
struct EnlargedBox {
  PhasePlaneBox box;
  int nx;
  int nv;
};
/// Returns the computational box of the grid enlarged by about the given factors, without changing
/// the cells inside the given grid.
EnlargedBox enlarge_box(const problem::Problem& problem, const FiniteVolumeOptions& options,
                        const PhasePlaneGrid& grid, double factor_x1, double factor_x2);

/// Returns a discretisation with the grid of `discretisation` and the excitation of another
/// problem.
PlaneDiscretisation discretise_excitation_on_same_grid(const problem::Problem& problem,
                                                       const FiniteVolumeOptions& options,
                                                       const PlaneDiscretisation& discretisation);

FokkerPlanckOperator fokker_planck_operator(const problem::Problem& problem,
                                            const FiniteVolumeOptions& options,
                                            const PlaneDiscretisation& discretisation);

/// Excitation on a uniform velocity axis, as input of fastest_growing_wave(). The velocity axis is
/// so long that the middle row of the excitation matrix equals the row for an unbounded axis.
struct ExcitationOnUnboundedAxis {
  GridAxis axis;
  DiscretisedExcitation excitation;
};
ExcitationOnUnboundedAxis unbounded_axis_excitation(const problem::Problem& problem,
                                                    const FiniteVolumeOptions& options,
                                                    double cell_width);

/// Returns the initial computational box, whose ends the solver moves outwards unless the options
/// set the ends. In the displacement x1 the computational box extends over 6 standard deviations of
/// equivalent linearisation from the static deflection. In the velocity x2 the computational box
/// extends over 7 standard deviations of equivalent linearisation, and at least 6.5 standard
/// deviations of the impulse amplitude. For problems without has_linearised_scales() the
/// computational box has the limits of problem::MotionScales, or ends at the walls.
PhasePlaneBox initial_box(const problem::Problem& problem, const FiniteVolumeOptions& options);
PhasePlaneBox initial_box(const problem::Problem& problem, const problem::MotionScales& scales,
                          const FiniteVolumeOptions& options);

/// Returns the length scales l of a density on a coarse grid from the Fisher information, l^-2 =
/// E[(d ln p/dx)^2]. For a normal density the length scales l are the standard deviations. A
/// density with several peaks, or concentrated on a ring, has length scales l below the standard
/// deviations. For the displacement x1, the derivative in the Fisher information is taken in the
/// coordinate in which all cells have equal widths.
DensityLengthScales fisher_length_scales(const problem::System& system, const PhasePlaneBox& box,
                                         const PhasePlaneGrid& grid,
                                         const Eigen::VectorXd& averages,
                                         const problem::MotionScales& scales);

}  // namespace fpkcheck::fd_fpk
