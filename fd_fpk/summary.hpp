#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/wall_density.hpp"
#include "fd_fpk/options.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/density.hpp"
#include "transform/metric.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::fd_fpk {

/// Estimate of the discretisation error, from coarser grids.
struct ErrorEstimate {
  double y_l1 = 0;                  ///< error of p(y), in L1
  double ydot_l1 = 0;               ///< error of p(y'), in L1
  transform::Moments moments = {};  ///< absolute errors: discretisation, and truncation by the box
  transform::Moments box_truncation = {};  ///< the part due to truncation by the box
  double observed_order = 0;               ///< from the decrease of the marginals' differences
  transform::Moments extrapolated = {};    ///< limits by Richardson extrapolation
  double factor = 0;  ///< estimated error of the finest grid, in units of the last difference
  std::vector<double> rest_probabilities =
      {};                  ///< errors of the probabilities of rest, for each atom
  double impact_rate = 0;  ///< error of Summary::impact_rate; not finite where the rate is infinite
  /// True if the observed order is consistent with the order of the scheme.
  bool has_limit = false;
};

/// Numerical data of a run of the solver, beside its density.
struct Summary {
  int nx = 0;
  int nv = 0;
  int order = 0;                 ///< order of the finite volumes, as used; 0 along characteristics
  double refinement = 1;         ///< refinement of the automatic cells, as used
  double origin_refinement = 1;  ///< as used
  double x1_max = 0;
  double x2_max = 0;
  Transport transport = Transport::upwind;  ///< as used
  long visits = 0;                          ///< number of cell visits of all characteristics
  double rest_mass = 0;     ///< mass at rest in equilibria (innermost cells; characteristics only)
  long nonzeros = 0;        ///< nonzeros of the operator without the jumps
  double leak = 0;          ///< largest rate at which the operator loses mass in a column
  long steps = 0;           ///< steps of CVODE; 0 for the direct solve
  long factorisations = 0;  ///< number of KLU factorisations on the final grid
  long rhs_evaluations = 0;
  long krylov_iterations = 0;  ///< total iterations of GMRES
  long factor_entries = 0;     ///< entries of both factors of the preconditioner
  double factor_seconds = 0;   ///< time of KLU factorisations on the final grid
  double krylov_seconds = 0;   ///< time of GMRES on the final grid
  double residual = 0;         ///< ||L P||_1 / ||P||_1 in units of sqrt(k_eq)
  double stepped_against_direct =
      0;  ///< max |difference| / max density; 0 for the direct solve alone
  double regularisation_length = 0;  ///< l of km4, else 0
  double growth_rate = 0;  ///< largest real part of the excitation's symbol (positive: ill-posed)
  double growth_wavenumber = 0;
  WallDensity wall{0, 0};  ///< density on the walls of the box, relative to the peak
  /// A larger box that measures the truncation error of this box; empty where that error is
  /// negligible.
  std::optional<BoxExtension> enlarged_box = {};
  transform::Moments moments_outside_box = {};  ///< estimated moments of the tails outside the box
  std::optional<ErrorEstimate> error = {};      ///< present where the options request an estimate
  /// Residuals of the balances, where there is a density.
  transform::BalanceResiduals balances = {};
  /// Impacts per unit time, int_{v<0} |v| p(0, v) dv; infinite where impacts end in rest in
  /// contact.
  double impact_rate = 0;
};

/// The metrics of this solver for its solution, in the order of summary.json. The errors in
/// transform::StatedError are not repeated.
transform::Metrics metrics(const Summary& summary);

/// A solution and the numerical data of its computation.
struct Result {
  transform::Solution solution;  ///< its density is a transform::GridDensity
  Summary summary;
};

}  // namespace fpkcheck::fd_fpk
