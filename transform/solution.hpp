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
#include "transform/observation.hpp"
#include "transform/smooth_bins.hpp"

namespace fpkcheck::transform {

/// How a solver ended. Not reaching a solution is a result, not an error.
enum class Status {
  ok,
  not_converged,  ///< the equations are not met
  ill_posed,      ///< the discrete problem as asked for grows without bound
  inaccurate,     ///< the equations are met, with an error larger than was asked for
  inadmissible,   ///< the equations are met, but by no probability density
  failed,         ///< the solver broke down
  not_offered     ///< the solver does not treat such a problem
};
/// As written in summary.json.
inline constexpr base::Named<Status> kStatusNames[] = {
    {Status::ok, "ok"},
    {Status::not_converged, "not_converged", "the equations are not met"},
    {Status::ill_posed, "ill_posed", "the discrete problem grows without bound"},
    {Status::inaccurate, "inaccurate", "the stated error is larger than was asked for"},
    {Status::inadmissible, "inadmissible",
     "the equations are met, but not by a probability density"},
    {Status::failed, "failed", "the solver broke down"},
    {Status::not_offered, "not_offered", "the solver does not treat such a problem"}};
constexpr std::span<const base::Named<Status>> names(Status) { return kStatusNames; }
constexpr std::string_view name(Status status) { return base::name_of(status); }

/// What a sequence of grids tends to, as far as its last two tell (Richardson):
/// limit = fine + factor (fine - coarser), with the solution's own density the fine one.
struct Extrapolation {
  Density coarser;
  double factor;  ///< 1/(R - 1) where differences of neighbouring grids fall by R
};

/// Of a solution that chance enters, in the units of what they belong to.
struct StandardErrors {
  Moments moments = {};
  double energy_residual = 0;
};

/// How far chance takes a marginal from the truth, in L1; nothing where a marginal has no errors.
struct SamplingError {
  std::optional<double> y{}, ydot{};        ///< expected
  std::optional<double> y_99{}, ydot_99{};  ///< what 99 runs of 100 stay below
};

/// A marginal as a simulation from which the noise was taken estimates it.
struct SmoothEstimate {
  SmoothBins bins;
  Marginal averages;               ///< with 95 % intervals
  std::vector<double> covariance;  ///< of the averages, row-major
};

/// An error by extrapolation is an estimate, whose band ends at this much of it: the factor of safety
/// of three grids and more (Roache, J. Fluids Eng. 116 (1994) 405).
inline constexpr double kErrorBand = 1.25;

/// What a method states of its own error (other than by chance).
struct StatedError {
  double y_l1 = 0;       ///< of p(y), in L1
  double ydot_l1 = 0;    ///< of p(y')
  Moments moments = {};  ///< absolute
};

/// The probability of rest in contact with a wall: the density's mass and these are 1 together.
struct RestAtom {
  double y = 0;  ///< of the wall
  double probability = 0;
  std::optional<double> standard_error = {};  ///< of a solution that chance enters
  std::optional<double> stated_error = {};    ///< what the method states of its own error
};

/// What every solver returns, whatever its method, and what a run that was saved has of it.
struct Solution {
  Identity identity;
  base::Values options = {};  ///< what was asked for
  Status status = Status::failed;
  std::string reason = {};  ///< one sentence; never empty unless the status is ok
  double seconds = 0;       ///< wall-clock time of the solve

  /// Absent when there is nothing that could be called a density, and in a run that was read back.
  std::optional<Density> density = {};
  /// Marginals that the solver estimated itself, with intervals (simulation); else empty.
  std::vector<std::pair<Variable, Marginal>> estimated_marginals = {};
  /// Marginals in smooth bins, known far better than the sharp ones (a simulation with control
  /// functions); else empty, and in a run that was read back.
  std::vector<std::pair<Variable, SmoothEstimate>> smooth_estimates = {};
  /// Where the solver also has a coarser grid and estimated its discretisation error.
  std::optional<Extrapolation> extrapolation = {};

  /// Of the density, where there is one.
  Moments moments = {};
  double mass = 0;                   ///< integral of the density as returned, with the atoms
  std::vector<RestAtom> atoms = {};  ///< at walls to which the mass is pressed; else none
  double min_density = 0;            ///< smallest value, relative to the largest
  double energy_residual = 0;        ///< problem::energy_residual

  std::optional<StandardErrors> standard_errors = {};
  std::optional<SamplingError> sampling = {};
  std::optional<SamplingError> smooth_sampling = {};  ///< of the smooth estimates
  std::optional<StatedError> error = {};
  Observations observations = {};  ///< what its solver alone knows

  /// In a run that was read back: there was a density.
  bool had_density = false;

  const std::string& id() const { return identity.id; }
  bool is_ok() const { return status == Status::ok; }
  /// Whether there is anything that could be called a density, and so moments and mass.
  bool has_density() const { return density || !estimated_marginals.empty() || had_density; }
};

/// Whether a solution states an error, its method's estimate or that of chance, of each marginal that
/// it has.
bool states_error(const Solution& solution);

/// Makes an ok solution that states no error `inaccurate`: `ok` says how far it is off.
void require_stated_error(Solution& solution);

/// The same, and of an ok solution whose stated error of p(y) or p(y') is larger than `accuracy`, in
/// L1.
/// @param reason why it is, without what was asked for
void hold_to(double accuracy, const std::string& reason, Solution& solution);

/// The solution with this id, or null.
const Solution* find_solution(std::span<const Solution> solutions, std::string_view id);

/// The marginal over the given bins: the solver's own estimate where it made one on these very
/// edges, else from the density.
/// @throws std::logic_error when the solution has no density
Marginal marginal(const Solution& solution, Variable variable, std::span<const double> edges);

/// The marginal of what the solution's grids tend to; averages near 0 may come out negative.
/// @throws std::logic_error when the solution has no density or no extrapolation
Marginal limit_marginal(const Solution& solution, Variable variable, std::span<const double> edges);

/// How far chance takes the best that is known of its marginals.
const std::optional<SamplingError>& best_sampling(const Solution& solution);
/// Its estimate in smooth bins, or null.
const SmoothEstimate* smooth_estimate(const Solution& solution, Variable variable);

/// The part that belongs to one variable.
std::optional<double> expected(const SamplingError& sampling, Variable variable);
std::optional<double> in_99(const SamplingError& sampling, Variable variable);
double l1(const StatedError& error, Variable variable);

}  // namespace fpkcheck::transform
