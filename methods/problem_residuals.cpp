#include "methods/problem_residuals.hpp"

#include <fmt/format.h>

#include <mutex>
#include <optional>

#include "dual/backward/normal_equations.hpp"
#include "dual/residual/density_residuals.hpp"
#include "dual/residual/offered.hpp"
#include "parameters/input_error.hpp"
#include "transform/change_of_frame.hpp"

namespace fpkcheck::methods {

using transform::Status;

struct ProblemResiduals::Fit {
  explicit Fit(const problem::Problem& of)
      : problem(problem::seen_from(problem::frame_of(of.system), of)),
        refused(dual::residuals_refused(problem)) {}

  problem::Problem problem;
  std::string refused;
  std::once_flag once = {};
  std::optional<dual::DensityResiduals> residuals = {};
};

ProblemResiduals::ProblemResiduals(const problem::Problem& problem)
    : fit_(std::make_unique<Fit>(problem)) {}
ProblemResiduals::ProblemResiduals(ProblemResiduals&&) noexcept = default;
ProblemResiduals::~ProblemResiduals() = default;

const dual::DensityResiduals* ProblemResiduals::get() const {
  std::call_once(fit_->once, [&] {
    if (!fit_->refused.empty()) return;
    try {
      fit_->residuals.emplace(fit_->problem);
    } catch (const dual::FitBrokeDown&) {
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

std::optional<transform::StatedError> measured_error(const ProblemResiduals& residuals,
                                                     const transform::Density& density,
                                                     const problem::Frame& coordinates) try {
  const auto* known = residuals.get();
  if (known == nullptr) return std::nullopt;
  if (coordinates == residuals.frame()) return known->of(density).stated();
  return known->of(transform::in_coordinates_of(residuals.frame(), density)).stated();
} catch (const InputError&) {
  return std::nullopt;  // nothing that has a mean
}

}  // namespace

void state_measured_error(const ProblemResiduals& residuals, double accuracy,
                          transform::Solution& solution, const problem::Frame& coordinates) {
  if (!solution.density) return;
  solution.error = measured_error(residuals, *solution.density, coordinates);
  if (!solution.is_ok()) return;
  if (!solution.error) {
    solution.status = Status::inaccurate;
    solution.reason = fmt::format("its error cannot be measured: {}",
                                  residuals.refused().empty()
                                      ? "the backward equation of this problem is not solved"
                                      : residuals.refused());
    return;
  }
  transform::hold_to(
      accuracy,
      fmt::format(
          "it meets its equations, but misses the density of the problem by L1 {:.2g} in p(y) and "
          "{:.2g} in p(y') as measured by its residuals",
          solution.error->y_l1, solution.error->ydot_l1),
      solution);
}

}  // namespace fpkcheck::methods
