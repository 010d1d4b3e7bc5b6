#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/options/value.hpp"
#include "transform/density.hpp"
#include "transform/identity.hpp"
#include "transform/marginal.hpp"
#include "transform/metric.hpp"
#include "transform/smooth_bins.hpp"

namespace fpkcheck::transform {

/// Outcome of a solver. A missing solution is a result, not an exception.
enum class Status {
  ok,
  not_converged,  ///< the equations are not satisfied
  ill_posed,      ///< the discrete problem as requested grows without bound
  inaccurate,     ///< the equations are satisfied; the error exceeds the requested accuracy
  inadmissible,   ///< the equations are satisfied, but the solution is no probability density
  failed,         ///< the solver failed
  not_offered     ///< the solver does not support the problem
};
/// As written in summary.json.
inline constexpr base::EnumEntry<Status> kStatusNames[] = {
    {Status::ok, "ok"},
    {Status::not_converged, "not_converged", "the equations are not satisfied"},
    {Status::ill_posed, "ill_posed", "the discrete problem grows without bound"},
    {Status::inaccurate, "inaccurate", "the error estimate exceeds the requested accuracy"},
    {Status::inadmissible, "inadmissible",
     "the equations are satisfied, but the solution is no probability density"},
    {Status::failed, "failed", "the solver failed"},
    {Status::not_offered, "not_offered", "the solver does not support the problem"}};
constexpr std::span<const base::EnumEntry<Status>> names(Status) { return kStatusNames; }
constexpr std::string_view name(Status status) { return base::name_of(status); }

/// Richardson extrapolation from the last two grids: limit = fine + factor (fine - coarser), where
/// `fine` is the density of the solution.
struct Extrapolation {
  Density coarser;
  double factor;  ///< 1/(R - 1), R the ratio by which differences of consecutive grids decrease
};

/// Standard errors of a simulated solution, in the units of the quantities.
struct StandardErrors {
  Moments moments = {};
  double energy_residual = 0;
};

/// Sampling error of the marginals in L1; empty for a marginal without standard errors.
struct SamplingError {
  std::optional<double> y{}, ydot{};        ///< expected value
  std::optional<double> y_99{}, ydot_99{};  ///< 99 % quantile over runs
};

/// A marginal over smooth bins, estimated by a simulation with control variates.
struct SmoothEstimate {
  SmoothBins bins;
  Marginal averages;               ///< with 95 % intervals
  std::vector<double> covariance;  ///< of the averages, row-major
};

/// Factor of safety on error estimates by extrapolation, for three or more grids (Roache, J. Fluids
/// Eng. 116 (1994) 405).
inline constexpr double kErrorSafetyFactor = 1.25;

/// Error estimate of a solution by its method, sampling errors excluded.
struct ErrorEstimate {
  double y_l1 = 0;       ///< of p(y), in L1
  double ydot_l1 = 0;    ///< of p(y')
  Moments moments = {};  ///< absolute
};

/// The probability of rest in contact with a wall. The mass of the density and the probabilities of
/// all rest atoms sum to 1.
struct RestAtom {
  double y = 0;  ///< position of the wall
  double probability = 0;
  std::optional<double> standard_error = {};  ///< of a simulation
  std::optional<double> error_estimate = {};  ///< error estimate by the method
};

/// The result of every solver, also as read back from a saved run.
struct Solution {
  Identity identity;
  base::Values options = {};  ///< options of the solver, as requested
  Status status = Status::failed;
  std::string reason = {};  ///< one sentence; empty only for status ok
  double seconds = 0;       ///< wall-clock time of the solve

  /// Empty if the solver found no density, and in a run that was read back.
  std::optional<Density> density = {};
  /// Marginals with confidence intervals, estimated by the solver (simulation); else empty.
  std::vector<std::pair<Variable, Marginal>> estimated_marginals = {};
  /// Marginals over smooth bins, far more accurate than those over sharp bins (simulation with
  /// control variates); else empty, also in a run that was read back.
  std::vector<std::pair<Variable, SmoothEstimate>> smooth_estimates = {};
  /// Present if the solver estimated its discretisation error from a coarser grid.
  std::optional<Extrapolation> extrapolation = {};

  /// Moments of the density, if there is one.
  Moments moments = {};
  double mass = 0;                   ///< integral of the density as returned, plus the atoms
  std::vector<RestAtom> atoms = {};  ///< at walls to which a force presses the mass; else empty
  double min_density = 0;            ///< smallest value relative to the largest
  double energy_residual = 0;        ///< problem::energy_residual

  std::optional<StandardErrors> standard_errors = {};
  std::optional<SamplingError> sampling = {};
  std::optional<SamplingError> smooth_sampling = {};  ///< of the smooth estimates
  std::optional<ErrorEstimate> error = {};
  Metrics metrics = {};  ///< solver-specific quantities

  /// In a run that was read back: whether the saved solution had a density.
  bool had_density = false;

  const std::string& id() const { return identity.id; }
  bool is_ok() const { return status == Status::ok; }
  /// True if there is a density or a marginal, and therefore moments and a mass.
  bool has_density() const { return density || !estimated_marginals.empty() || had_density; }
};

/// True if a solution has an error estimate, or a sampling error, of each of its marginals.
bool has_error_estimate(const Solution& solution);

/// Sets the status of an ok solution without an error estimate to `inaccurate`: status ok requires
/// an error estimate.
void require_error_estimate(Solution& solution);

/// Calls require_error_estimate(), and sets the status of an ok solution to `inaccurate` if its
/// error estimate of p(y) or p(y') in L1 exceeds `accuracy`.
/// @param reason the error found; the function appends the requested accuracy
void require_accuracy(double accuracy, const std::string& reason, Solution& solution);

/// The solution with this id, or null.
const Solution* find_solution(std::span<const Solution> solutions, std::string_view id);

/// The marginal over the given bins: the solver's estimate if it has exactly these edges, else the
/// marginal of the density.
/// @throws std::logic_error when the solution has no density
Marginal marginal(const Solution& solution, Variable variable, std::span<const double> edges);

/// The marginal of the Richardson limit of the solution's grids; averages near 0 may become
/// negative.
/// @throws std::logic_error when the solution has no density or no extrapolation
Marginal limit_marginal(const Solution& solution, Variable variable, std::span<const double> edges);

/// Sampling error of the most accurate marginals: over smooth bins if there are any, else over
/// sharp bins.
const std::optional<SamplingError>& best_sampling_error(const Solution& solution);
/// The estimate over smooth bins, or null.
const SmoothEstimate* smooth_estimate(const Solution& solution, Variable variable);

/// Values for one variable.
std::optional<double> expected(const SamplingError& sampling, Variable variable);
std::optional<double> quantile_99(const SamplingError& sampling, Variable variable);
double l1(const ErrorEstimate& error, Variable variable);

}  // namespace fpkcheck::transform
