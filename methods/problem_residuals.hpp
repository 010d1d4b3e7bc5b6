#pragma once

#include <memory>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::dual {
class DensityResiduals;
}  // namespace fpkcheck::dual

namespace fpkcheck::methods {

/// The backward equations of a problem, by which densities know their own errors, solved when first
/// asked for and once for all who ask.
class ProblemResiduals {
 public:
  explicit ProblemResiduals(const problem::Problem& problem);
  ProblemResiduals(ProblemResiduals&&) noexcept;
  ~ProblemResiduals();

  /// Null where the fit breaks down. May be called from several threads.
  const dual::DensityResiduals* get() const;

 private:
  struct Fit;
  std::unique_ptr<Fit> fit_;
};

/// One for each problem, in their order.
std::vector<ProblemResiduals> residuals_of(const std::vector<problem::Problem>& problems);

/// Gives a solution with a density its error against the full problem (whatever it solves itself)
/// as dual-weighted residuals measure it (dual/residual/density_residuals.hpp). If it is ok, but
/// off by more in L1, or not to be measured, it becomes `inaccurate`.
/// @param accuracy largest error of p(y) and of p(y') in L1
void state_measured_error(const ProblemResiduals& residuals, double accuracy,
                          transform::Solution& solution);

}  // namespace fpkcheck::methods
