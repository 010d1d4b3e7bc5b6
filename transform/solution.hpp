#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/energy_balance.hpp"
#include "transform/density.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::transform {

/// How a solver ended. Not reaching a solution is a result, not an error.
enum class Status {
  ok,
  not_converged,  ///< the equations are not met
  ill_posed,      ///< the discrete problem as asked for grows without bound
  inadmissible,   ///< the equations are met, but by no probability density
  failed          ///< the solver broke down
};

/// The status as written in summary.json.
std::string_view name(Status status);

/// What a sequence of grids tends to, as far as its last two tell (Richardson):
/// limit = fine + factor (fine - coarser), with the solution's own density the fine one.
struct Extrapolation {
  Density coarser;
  double factor;  ///< 1/(R - 1) where differences of neighbouring grids fall by R
};

/// What every solver returns, whatever its method.
struct Solution {
  std::string id = {};   ///< e.g. "epc-gaussian-n6", "fd-kf", "mcs"
  std::string method;    ///< "epc", "fd" or "mcs"
  std::string equation;  ///< "white", "km4" or "kf": the excitation term that was solved
  problem::Impact impact = problem::Impact::map;
  Status status = Status::failed;
  std::string reason = {};  ///< one sentence; never empty unless the status is ok
  double seconds = 0;       ///< wall-clock time of the solve

  /// Absent when there is nothing that could be called a density.
  std::optional<Density> density = {};
  /// Marginals that the solver estimated itself, with intervals (simulation); else empty.
  std::vector<std::pair<Variable, Marginal>> estimated_marginals = {};
  /// Where the solver also has a coarser grid and estimated its discretisation error.
  std::optional<Extrapolation> extrapolation = {};

  Moments moments = {};
  double mass = 0;             ///< integral of the density as returned
  double min_density = 0;      ///< smallest value, relative to the largest
  double energy_residual = 0;  ///< problem::energy_residual
};

/// The marginal over the given bins: the solver's own estimate where it made one on these very
/// edges, else from the density.
/// @throws std::logic_error when the solution has no density
Marginal marginal(const Solution& solution, Variable variable, std::span<const double> edges);

/// The marginal of what the solution's grids tend to; averages near 0 may come out negative.
/// @throws std::logic_error when the solution has no density or no extrapolation
Marginal limit_marginal(const Solution& solution, Variable variable, std::span<const double> edges);

}  // namespace fpkcheck::transform
