#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/options/parameter_value.hpp"
#include "transform/joint_density.hpp"
#include "transform/marginal_density.hpp"
#include "transform/smooth_bins.hpp"
#include "transform/solution_identity.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::transform {

/// Status of the result of a solver. A solver that finds no solution returns a status instead of
/// throwing an exception.
enum class Status { ok, not_converged, ill_posed, inaccurate, inadmissible, failed, not_offered };
inline constexpr base::EnumEntry<Status> kStatusNames[] = {
    {Status::ok, "ok"},
    {Status::not_converged, "not_converged", "the equations are not satisfied"},
    {Status::ill_posed, "ill_posed", "the discrete problem grows without bound"},
    {Status::inaccurate, "inaccurate", "the error estimate exceeds the requested accuracy"},
    {Status::inadmissible, "inadmissible",
     "the equations are satisfied, but the solution is no probability density"},
    {Status::failed, "failed", "the solver failed"},
    {Status::not_offered, "not_offered", "the solver does not support the problem"}};
constexpr const auto& enumerator_names(Status) { return kStatusNames; }
constexpr std::string_view name(Status status) { return base::name_of(status); }

/// Richardson extrapolation from the last two grids: limit = fine + factor (fine - coarser), where
/// `fine` is the density of the solution.
struct CoarserGridDensity {
  Density coarser;
  double factor;  ///< 1/(R - 1), where R is the ratio of consecutive differences between grids
};

/// Absolute standard errors of the quantities of a simulation.
struct MomentStandardErrors {
  Moments moments = {};
  double energy_residual = 0;
};

/// Sampling errors in L1 of the marginal densities of a simulation; empty for a marginal density
/// without standard errors.
struct MarginalSamplingErrors {
  std::optional<double> y{}, ydot{};        ///< expected value of the L1 error
  std::optional<double> y_99{}, ydot_99{};  ///< 99 % quantile of the L1 error over repeated runs
};

/// A marginal over smooth bins, estimated by a simulation with control variates.
struct SmoothBinEstimate {
  SmoothBins bins;
  Marginal averages;               ///< averages of the density with 95 % confidence intervals
  std::vector<double> covariance;  ///< covariance matrix of the averages, row-major
};

/// Factor of safety of error estimates by Richardson extrapolation from three or more grids
/// (Roache, Journal of Fluids Engineering 116 (1994) 405).
inline constexpr double kErrorSafetyFactor = 1.25;

/// Error estimate of a solution by its own method, without sampling errors.
struct ErrorEstimate {
  double y_l1 = 0;       ///< L1 error of the marginal p(y)
  double ydot_l1 = 0;    ///< L1 error of the marginal p(y')
  Moments moments = {};  ///< absolute errors of the moments
};

/// A rest atom: the probability of rest in contact with a wall. The sum of the mass of the density
/// and the probabilities of all atoms at rest is 1.
struct RestAtom {
  double y = 0;  ///< position of the wall with the atom
  double probability = 0;
  std::optional<double> standard_error = {};
  std::optional<double> error_estimate = {};
};

/// The result of a solver, or a result that was read from a saved run.
struct Solution {
  SolutionIdentity identity;
  base::Values options = {};  ///< options of the solver, as the user requested
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;       ///< wall-clock time of the solver in seconds

  /// Joint density; empty if the solver found no density, or for a solution from a saved run.
  std::optional<Density> density = {};
  /// Marginals with confidence intervals, estimated by a simulation; empty for other solvers.
  std::vector<std::pair<StateVariable, Marginal>> estimated_marginals = {};
  /// Marginals over smooth bins from a simulation with control variates. The sampling errors of
  /// marginals over smooth bins are far smaller than the sampling errors of marginals over sharp
  /// bins. Solutions of other solvers and of saved runs have no marginals over smooth bins.
  std::vector<std::pair<StateVariable, SmoothBinEstimate>> smooth_estimates = {};
  /// Richardson extrapolation, if the solver estimated its discretisation error from a coarser
  /// grid.
  std::optional<CoarserGridDensity> extrapolation = {};

  /// Moments of the density; not set if there is no density.
  Moments moments = {};
  double mass = 0;  ///< integral of the density plus the probabilities of the atoms
  std::vector<RestAtom> atoms = {};  ///< probabilities of rest on the walls
  double min_density = 0;      ///< smallest value of the density, relative to the largest value
  double energy_residual = 0;  ///< result of problem::power_balance_residual()

  std::optional<MomentStandardErrors> standard_errors = {};
  std::optional<MarginalSamplingErrors> sampling = {};
  std::optional<MarginalSamplingErrors> smooth_sampling = {};
  std::optional<ErrorEstimate> error = {};
  Metrics metrics = {};

  /// Whether a solution from a saved run had a density when the run was saved.
  bool had_density = false;

  const std::string& id() const { return identity.id; }
  bool has_status_ok() const { return status == Status::ok; }
  /// Returns whether the solution has a density or a marginal, and therefore moments and a mass.
  bool has_density() const { return density || !estimated_marginals.empty() || had_density; }
};

/// Returns whether a solution has an error estimate, or a sampling error, for each of its
/// marginals.
bool has_error_estimate(const Solution& solution);

/// Changes the status `ok` of a solution without an error estimate to `inaccurate`.
void require_error_estimate(Solution& solution);

/// Changes the status `ok` of a solution to `inaccurate` if the L1 error estimate of p(y) or p(y')
/// is missing or exceeds `accuracy`.
/// @param reason text that states the error, to which the function appends the requested accuracy
void require_accuracy(double accuracy, const std::string& reason, Solution& solution);

const Solution* find_solution(std::span<const Solution> solutions, std::string_view id);

/// Returns the marginal of a solution over the bins between `edges`. If the solver estimated a
/// marginal over exactly these bins, the function returns this estimate, otherwise the marginal of
/// the density.
/// @throws std::logic_error if the solution has no density
Marginal marginal(const Solution& solution, StateVariable variable, std::span<const double> edges);

/// Returns the marginal of the Richardson limit of the densities on the grids of a solution.
/// Extrapolated bin averages near 0 may be negative.
/// @throws std::logic_error if the solution has no density or no extrapolation
Marginal richardson_limit_marginal(const Solution& solution, StateVariable variable,
                                   std::span<const double> edges);

/// Returns the sampling error of the marginals over smooth bins. If the solution has no marginals
/// over smooth bins, the result is the sampling error of the marginals over sharp bins.
const std::optional<MarginalSamplingErrors>& smallest_known_sampling_errors(
    const Solution& solution);
const SmoothBinEstimate* find_smooth_bin_estimate(const Solution& solution, StateVariable variable);

std::optional<double> expected_l1_error(const MarginalSamplingErrors& sampling,
                                        StateVariable variable);
std::optional<double> l1_error_quantile_99(const MarginalSamplingErrors& sampling,
                                           StateVariable variable);
double l1_error_of_marginal(const ErrorEstimate& error, StateVariable variable);

}  // namespace fpkcheck::transform
