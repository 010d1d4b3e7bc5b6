#include "methods/residual_error_estimator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "backward/generator/normal_equations.hpp"
#include "backward/residual/density_error_estimator.hpp"
#include "base/input_error.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::methods {

using transform::Status;

struct ResidualErrorEstimator::LazyFit {
  explicit LazyFit(const problem::Problem& of)
      : problem(problem::to_wall_coordinates(problem::wall_frame(of.system), of)),
        unsupported_reason(backward::residuals_unsupported_reason(problem)) {}

  problem::Problem problem;
  std::string unsupported_reason;
  std::once_flag once = {};
  std::optional<backward::DensityErrorEstimator> estimator = {};
};

ResidualErrorEstimator::ResidualErrorEstimator(const problem::Problem& problem)
    : fit_(std::make_unique<LazyFit>(problem)) {}
ResidualErrorEstimator::ResidualErrorEstimator(ResidualErrorEstimator&&) noexcept = default;
ResidualErrorEstimator::~ResidualErrorEstimator() = default;

const backward::DensityErrorEstimator* ResidualErrorEstimator::density_error_estimator() const {
  std::call_once(fit_->once, [&] {
    if (!fit_->unsupported_reason.empty()) return;
    try {
      fit_->estimator.emplace(fit_->problem);
    } catch (const backward::LeastSquaresFitFailure&) {
    }
  });
  return fit_->estimator ? &*fit_->estimator : nullptr;
}

const problem::WallFrame& ResidualErrorEstimator::wall_coordinates() const {
  return fit_->problem.frame;
}
const std::string& ResidualErrorEstimator::unsupported_reason() const {
  return fit_->unsupported_reason;
}

std::vector<ResidualErrorEstimator> make_error_estimators(
    const std::vector<problem::Problem>& problems) {
  return {problems.begin(), problems.end()};
}

namespace {

std::optional<backward::DensityErrorEstimates> estimate_density_errors(
    const ResidualErrorEstimator& estimator, const transform::Density& density,
    const problem::WallFrame& coordinates) try {
  const auto* density_estimator = estimator.density_error_estimator();
  if (density_estimator == nullptr) return std::nullopt;
  if (coordinates == estimator.wall_coordinates())
    return density_estimator->estimate_errors(density);
  return density_estimator->estimate_errors(
      transform::to_wall_coordinates(estimator.wall_coordinates(), density));
} catch (const InputError&) {
  return std::nullopt;  // no error estimate for a density without a mean
}

std::string missing_estimate_reason(
    const ResidualErrorEstimator& estimator,
    const std::optional<backward::DensityErrorEstimates>& weighted) {
  if (weighted) {
    return "the error is unknown: the solution of the backward equation is too coarse for this "
           "problem; compare with fd or mcs";
  }
  return fmt::format("the error cannot be estimated: {}",
                     estimator.unsupported_reason().empty()
                         ? "the backward equation of this problem cannot be solved"
                         : estimator.unsupported_reason());
}

// Returns the reason why an error estimate exceeds the required accuracy: either the density is
// inaccurate, or the error estimate is only an upper bound that is much larger than the error.
std::string large_estimate_reason(const backward::DensityErrorEstimates& weighted,
                                  const transform::ErrorEstimate& error, double accuracy) {
  const double found =
      backward::DensityErrorEstimates::kSubBinFactor *
      std::max(weighted.y_l1.dual_weighted_error, weighted.ydot_l1.dual_weighted_error);
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

void set_residual_error_estimate(const ResidualErrorEstimator& estimator, double accuracy,
                                 transform::Solution& solution,
                                 const problem::WallFrame& coordinates,
                                 std::string_view reason_prefix) {
  if (!solution.density) return;
  const auto weighted = estimate_density_errors(estimator, *solution.density, coordinates);
  solution.error = weighted ? weighted->error_estimate() : std::nullopt;
  if (!solution.has_status_ok()) return;
  if (!solution.error) {
    solution.status = Status::inaccurate;
    solution.reason = missing_estimate_reason(estimator, weighted);
    return;
  }
  transform::require_accuracy(
      accuracy,
      fmt::format("{}{}", reason_prefix,
                  large_estimate_reason(*weighted, *solution.error, accuracy)),
      solution);
}

}  // namespace fpkcheck::methods
