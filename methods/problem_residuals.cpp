#include "methods/problem_residuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "backward/generator/normal_equations.hpp"
#include "backward/residual/applicability.hpp"
#include "backward/residual/density_residuals.hpp"
#include "base/input_error.hpp"
#include "transform/change_of_frame.hpp"

namespace fpkcheck::methods {

using transform::Status;

struct ProblemResiduals::Fit {
  explicit Fit(const problem::Problem& of)
      : problem(problem::to_wall_coordinates(problem::wall_frame(of.system), of)),
        refused(backward::residuals_unsupported_reason(problem)) {}

  problem::Problem problem;
  std::string refused;
  std::once_flag once = {};
  std::optional<backward::DensityResiduals> residuals = {};
};

ProblemResiduals::ProblemResiduals(const problem::Problem& problem)
    : fit_(std::make_unique<Fit>(problem)) {}
ProblemResiduals::ProblemResiduals(ProblemResiduals&&) noexcept = default;
ProblemResiduals::~ProblemResiduals() = default;

const backward::DensityResiduals* ProblemResiduals::get() const {
  std::call_once(fit_->once, [&] {
    if (!fit_->refused.empty()) return;
    try {
      fit_->residuals.emplace(fit_->problem);
    } catch (const backward::FitFailure&) {
    }
  });
  return fit_->residuals ? &*fit_->residuals : nullptr;
}

const problem::Frame& ProblemResiduals::frame() const { return fit_->problem.frame; }
const std::string& ProblemResiduals::refused() const { return fit_->refused; }

std::vector<ProblemResiduals> residuals_of(const std::vector<problem::Problem>& problems) {
  return {problems.begin(), problems.end()};
}

namespace {

std::optional<backward::DensityErrors> measured(const ProblemResiduals& residuals,
                                                const transform::Density& density,
                                                const problem::Frame& coordinates) try {
  const auto* known = residuals.get();
  if (known == nullptr) return std::nullopt;
  if (coordinates == residuals.frame()) return known->estimate_errors(density);
  return known->estimate_errors(transform::to_wall_coordinates(residuals.frame(), density));
} catch (const InputError&) {
  return std::nullopt;  // the density has no mean
}

// The reason for a missing error estimate.
std::string no_estimate(const ProblemResiduals& residuals,
                        const std::optional<backward::DensityErrors>& weighted) {
  if (weighted) {
    return "the error is unknown: the solution of the backward equation is too coarse for this "
           "problem; compare with fd or mcs";
  }
  return fmt::format("the error cannot be estimated: {}",
                     residuals.refused().empty()
                         ? "the backward equation of this problem cannot be solved"
                         : residuals.refused());
}

// The reason for an error estimate above the required accuracy: an inaccurate density, or an
// estimate that is only an upper bound.
std::string too_large(const backward::DensityErrors& weighted,
                      const transform::ErrorEstimate& error, double accuracy) {
  const double found = backward::DensityErrors::kSubBinFactor *
                       std::max(weighted.y_l1.found, weighted.ydot_l1.found);
  if (found <= accuracy) {
    return fmt::format(
        "the residuals only bound the error by L1 {:.2g} in p(y) and {:.2g} in p(y'): the solution "
        "of the backward equation is too coarse for a sharper bound",
        error.y_l1, error.ydot_l1);
  }
  return fmt::format("the residual-based L1 error estimate is {:.2g} in p(y) and {:.2g} in p(y')",
                     error.y_l1, error.ydot_l1);
}

}  // namespace

void state_measured_error(const ProblemResiduals& residuals, double accuracy,
                          transform::Solution& solution, const problem::Frame& coordinates,
                          std::string_view opening) {
  if (!solution.density) return;
  const auto weighted = measured(residuals, *solution.density, coordinates);
  solution.error = weighted ? weighted->error_estimate() : std::nullopt;
  if (!solution.is_ok()) return;
  if (!solution.error) {
    solution.status = Status::inaccurate;
    solution.reason = no_estimate(residuals, weighted);
    return;
  }
  transform::require_accuracy(
      accuracy, fmt::format("{}{}", opening, too_large(*weighted, *solution.error, accuracy)),
      solution);
}

}  // namespace fpkcheck::methods
