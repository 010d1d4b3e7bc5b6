#pragma once

#include <optional>
#include <vector>

#include "fd_fpk/operator/discretisation.hpp"
#include "fd_fpk/operator/wall_density.hpp"
#include "fd_fpk/options.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/density.hpp"
#include "transform/observation.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::fd_fpk {

/// What is known of the discretisation error, from coarser grids.
struct ErrorEstimate {
  double y_l1 = 0;                       ///< of p(y), in L1
  double ydot_l1 = 0;                    ///< of p(y')
  transform::Moments moments = {};       ///< absolute; of the cells, and of the walls
  transform::Moments of_walls = {};      ///< what of it is theirs
  double observed_order = 0;             ///< at which the marginals' differences fall
  transform::Moments extrapolated = {};  ///< Richardson limits
  double factor = 0;                     ///< of the last difference that is still missing
  std::vector<double> at_rest = {};      ///< of the probabilities of rest, by atom
  double impact_rate = 0;                ///< of Summary::impact_rate; not finite where that is not
  bool has_limit = false;                ///< the observed order is one that the scheme may have
};

/// What a run of the solver reports beyond its density.
struct Summary {
  int nx = 0;
  int nv = 0;
  int order = 0;                 ///< of the differences, as used; 0 along characteristics
  double refinement = 1;         ///< of the automatic cells, as used
  double origin_refinement = 1;  ///< as used
  double x1_max = 0;
  double x2_max = 0;
  Transport transport = Transport::upwind;  ///< as used
  long visits = 0;                          ///< of cells by characteristics
  double rest_mass = 0;                     ///< of the two innermost cells of characteristics
  long nonzeros = 0;                        ///< of the operator without the jumps
  double leak = 0;                          ///< largest rate at which the operator would lose mass
  long steps = 0;                           ///< of CVODE; 0 for the direct solve
  long factorisations = 0;                  ///< KLU factorisations on the final grid
  long rhs_evaluations = 0;
  long krylov_iterations = 0;  ///< of GMRES, in all
  long factor_entries = 0;     ///< of both factors of the preconditioner
  double factor_seconds = 0;   ///< in KLU factorisations on the final grid
  double krylov_seconds = 0;   ///< in GMRES on the final grid
  double residual = 0;         ///< ||L P||_1 / ||P||_1 in units of sqrt(k_eq)
  double stepped_against_direct =
      0;  ///< max |difference| / max density; 0 for the direct solve alone
  double regularisation_length = 0;  ///< l of km4, else 0
  double growth_rate = 0;  ///< largest real part of the excitation's symbol (> 0: ill-posed)
  double growth_wavenumber = 0;
  WallDensity wall{0, 0};                     ///< density on the outer walls relative to the peak
  std::optional<Extent> wider = {};           ///< what shows what the walls do, where they matter
  transform::Moments beyond_box = {};         ///< what else is known of that: of the moments
  std::optional<ErrorEstimate> error = {};    ///< where it was asked for
  transform::BalanceResiduals balances = {};  ///< of the density, where there is one
  /// Impacts per unit time, int_{v<0} |v| p(0, v) dv; infinite where they end in rest.
  double impact_rate = 0;
};

/// What this solver alone knows of its solution, in the order of summary.json. The errors that
/// transform::StatedError holds are not repeated.
transform::Observations observations(const Summary& summary);

/// A solution and how it came about.
struct Result {
  transform::Solution solution;  ///< density as transform::GridDensity
  Summary summary;
};

}  // namespace fpkcheck::fd_fpk
