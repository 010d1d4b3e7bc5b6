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

/// Data for the Richardson limit = fine + factor (fine - coarser), where `fine` is the density of
/// the solution on the finest grid, and `coarser` the density on the next coarser grid.
struct CoarserGridDensity {
  Density coarser;
  double factor;  ///< 1/(R - 1), where R is the ratio of consecutive differences between grids
};

/// Absolute standard errors of the quantities of a simulation.
struct MomentStandardErrors {
  Moments moments = {};
  double energy_residual = 0;
};

/// L1 sampling errors of the marginal densities of a simulation; empty for a marginal density
/// without standard errors.
struct MarginalSamplingErrors {
  std::optional<double> y{}, ydot{};        ///< expected value of the L1 error
  std::optional<double> y_99{}, ydot_99{};  ///< 99 % quantile of the L1 error over repeated runs
};

/// A marginal density over smooth bins, estimated by a simulation with control variates.
struct SmoothBinEstimate {
  SmoothBins bins;
  Marginal averages;               ///< averages of the density with 95 % confidence intervals
  std::vector<double> covariance;  ///< covariance matrix of the averages, row-major
};

/// Factor of safety of error estimates by Richardson extrapolation from three or more grids
/// (Roache, Journal of Fluids Engineering 116 (1994) 405).
inline constexpr double kErrorSafetyFactor = 1.25;

/// Error estimate of a solution by the method that computed the solution, without sampling errors.
struct ErrorEstimate {
  double y_l1 = 0;       ///< L1 error of the marginal p(y)
  double ydot_l1 = 0;    ///< L1 error of the marginal p(y')
  Moments moments = {};  ///< absolute errors of the moments
};

/// A rest atom: the probability of rest in contact with a wall. The mass of the density and the
/// probabilities of all atoms at rest have the sum 1.
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

  /// Joint density; empty if the solver found no density, and for a solution from a saved run.
  std::optional<Density> density = {};
  /// Marginals with confidence intervals, estimated by a simulation; empty for other solvers.
  std::vector<std::pair<StateVariable, Marginal>> estimated_marginals = {};
  /// Marginal densities over smooth bins from a simulation with control variates. The sampling
  /// errors of marginals over smooth bins are far smaller than the sampling errors of marginals
  /// over sharp bins. Solutions of other solvers and of saved runs have no marginals over smooth
  /// bins.
  std::vector<std::pair<StateVariable, SmoothBinEstimate>> smooth_estimates = {};
  /// Data for the Richardson limit, if the solver also solved the problem on a coarser grid.
  std::optional<CoarserGridDensity> extrapolation = {};

  /// Moments of the density; not set for a solution without a density.
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

/// Returns whether a solution has an error estimate or a sampling error for each of its marginals.
bool has_error_estimate(const Solution& solution);

/// Changes the status `ok` of a solution without an error estimate to `inaccurate`.
void require_error_estimate(Solution& solution);

/// Changes the status `ok` of a solution to `inaccurate` if the L1 error estimate of p(y) or p(y')
/// is missing or exceeds `accuracy`.
/// @param reason text that states the error, to which require_accuracy() appends the requested
/// accuracy
void require_accuracy(double accuracy, const std::string& reason, Solution& solution);

const Solution* find_solution(std::span<const Solution> solutions, std::string_view id);

/// Returns the marginal density of a solution over the bins between `edges`: the estimate of the
/// solver if the solver used exactly these bin edges, otherwise the marginal of the joint density.
/// @throws std::logic_error if the solution has no density
Marginal marginal(const Solution& solution, StateVariable variable, std::span<const double> edges);

/// Returns the marginal density of the Richardson limit from the finest and the next coarser grid
/// of a solution. Extrapolated bin averages of a density near 0 may be negative.
/// @throws std::logic_error if the solution has no density or no extrapolation
Marginal richardson_limit_marginal(const Solution& solution, StateVariable variable,
                                   std::span<const double> edges);

/// Returns the sampling errors of the marginals over smooth bins, or, for a solution without
/// marginals over smooth bins, the sampling errors of the marginals over sharp bins.
const std::optional<MarginalSamplingErrors>& smallest_known_sampling_errors(
    const Solution& solution);
const SmoothBinEstimate* find_smooth_bin_estimate(const Solution& solution, StateVariable variable);

std::optional<double> expected_l1_error(const MarginalSamplingErrors& sampling,
                                        StateVariable variable);
std::optional<double> l1_error_quantile_99(const MarginalSamplingErrors& sampling,
                                           StateVariable variable);
double l1_error_of_marginal(const ErrorEstimate& error, StateVariable variable);

}  // namespace fpkcheck::transform
