#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {
class DensityResiduals;
}  // namespace fpkcheck::backward

namespace fpkcheck::methods {

/// The backward equations of a problem, by which densities know their own errors, solved in its
/// frame when first asked for and once for all who ask.
class ProblemResiduals {
 public:
  /// @param problem as it is or in its frame
  explicit ProblemResiduals(const problem::Problem& problem);
  ProblemResiduals(ProblemResiduals&&) noexcept;
  ~ProblemResiduals();

  /// Of densities in the problem's frame. Null where the fit breaks down, or none is offered
  /// (backward::residuals_unsupported_reason). May be called from several threads.
  const backward::DensityResiduals* get() const;
  /// Of the problem.
  const problem::Frame& frame() const;
  /// Why there are none for such a problem, in one phrase; empty where there are.
  const std::string& refused() const;

 private:
  struct Fit;
  std::unique_ptr<Fit> fit_;
};

/// One for each problem, in their order.
std::vector<ProblemResiduals> residuals_of(const std::vector<problem::Problem>& problems);

/// Gives a solution with a density its error against the full problem (whatever it solves itself)
/// as dual-weighted residuals measure it (backward/residual/density_residuals.hpp). If it is ok, but
/// off by more in L1, or not to be measured, it becomes `inaccurate`.
/// @param accuracy largest error of p(y) and of p(y') in L1
/// @param coordinates in which its density lies: the physical ones unless it is in the frame
/// @param opening of the reason, where the error is known but too large
void state_measured_error(const ProblemResiduals& residuals, double accuracy,
                          transform::Solution& solution, const problem::Frame& coordinates = {},
                          std::string_view opening = "it meets its equations, but ");

}  // namespace fpkcheck::methods
