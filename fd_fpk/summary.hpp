#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/options.hpp"
#include "transform/joint_density.hpp"
#include "transform/solution.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::fd_fpk {

/// Estimates of the discretisation errors from solutions on coarser grids.
struct DiscretisationErrorEstimate {
  double y_l1 = 0;
  double ydot_l1 = 0;
  /// Estimated absolute errors of the moments, due to the grid and to the finite computational box
  transform::Moments moments = {};
  transform::Moments box_truncation = {};  ///< part of `moments` due to the finite box
  /// Order of convergence observed in the differences of the marginal densities
  double observed_order = 0;
  transform::Moments extrapolated = {};  ///< limits of the moments by Richardson extrapolation
  /// Estimated discretisation error on the finest grid over the difference of the two finest
  /// solutions
  double factor = 0;
  std::vector<double> rest_probabilities = {};  ///< error of the probability of each atom at rest
  double impact_rate =
      0;  ///< error of FiniteVolumeSummary::impact_rate; infinite for an infinite rate
  /// Whether the observed order of convergence is consistent with the order of the scheme
  bool has_richardson_limit = false;
};

/// Numerical data of one solution by finite volumes or characteristics, without the density.
struct FiniteVolumeSummary {
  int nx = 0;
  int nv = 0;
  /// Order of accuracy of the finite volumes; 0 for transport along characteristics
  int order = 0;
  double refinement = 1;         ///< factor FiniteVolumeOptions::refinement of the solution
  double origin_refinement = 1;  ///< ratio FiniteVolumeOptions::origin_refinement of the solution
  double x1_max = 0;
  double x2_max = 0;
  TransportScheme transport = TransportScheme::upwind;
  long visits = 0;          ///< number of cell visits of all characteristics
  double rest_mass = 0;     ///< mass at rest in equilibria (innermost cells; characteristics only)
  long nonzeros = 0;        ///< nonzeros of the operator without the jumps
  double leak = 0;          ///< largest rate of mass loss of the operator in a cell
  long steps = 0;           ///< number of steps of CVODE; 0 for the direct solution
  long factorisations = 0;  ///< number of factorisations by KLU on the final grid
  long rhs_evaluations = 0;
  long krylov_iterations = 0;
  long factor_entries = 0;  ///< number of entries of the L and U factors of the preconditioner
  double factor_seconds = 0;
  double krylov_seconds = 0;
  double residual = 0;  ///< stationarity residual ||L P||_1 / ||P||_1, in units of sqrt(k_eq)
  /// Largest difference of the densities from pseudo-transient time steps and from the direct
  /// solution, relative to the peak density
  double stepped_against_direct = 0;
  double regularisation_length = 0;  ///< regularisation length l of km4; 0 for other equations
  double growth_rate = 0;  ///< largest real part of the excitation's symbol (positive: ill-posed)
  double growth_wavenumber = 0;
  BoxEdgeDensity wall{0, 0};  ///< density on the edges of the box, relative to the peak
  /// Larger computational box, in which a second solution measures the truncation error of the
  /// first computational box, if this error is not negligible
  std::optional<EnlargedBox> enlarged_box = {};
  transform::Moments moments_outside_box = {};  ///< estimated moments of the tails outside the box
  /// Estimated discretisation errors; absent if the options do not request an error estimate
  std::optional<DiscretisationErrorEstimate> error = {};
  /// Whether the error estimate is at least as large as the residuals of the balances, since the
  /// observed order of convergence may be too high
  bool balances_limit_errors = false;
  /// Mean absolute power E[|v f|] of the damping force f in units of the input power, for motion
  /// along a limit cycle; otherwise 1. Along a limit cycle the damping force supplies and
  /// dissipates many times the input power, so that small errors of the density cause large
  /// residuals of the balances.
  double exchanged_power = 1;
  /// Residuals of the balances of power, virial and momentum; absent without a density
  transform::BalanceResiduals balances = {};
  /// Impacts per unit time, int_{v<0} |v| p(0, v) dv for the density p; infinite if the oscillator
  /// comes to rest in contact after infinitely many impacts
  double impact_rate = 0;
};

/// Returns the metrics of the solver in the order of summary.json, without
/// transform::ErrorEstimate.
transform::Metrics solver_metrics(const FiniteVolumeSummary& summary);

struct FiniteVolumeResult {
  transform::Solution solution;  ///< solution whose density is a transform::GridDensity
  FiniteVolumeSummary summary;
};

}  // namespace fpkcheck::fd_fpk
