#include "compare/model_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/smooth_reference.hpp"

namespace fpkcheck::compare {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::Marginal;
using transform::Solution;
using transform::SolutionRole;
using transform::StateVariable;

const Marginal* find_marginal(std::span<const SolutionMarginalDensity> marginals,
                              const std::string& id, StateVariable variable) {
  for (const auto& candidate : marginals) {
    if (candidate.solution != id || candidate.variable != variable) continue;
    const bool finite =
        std::ranges::all_of(candidate.marginal.density, [](double p) { return std::isfinite(p); });
    return finite ? &candidate.marginal : nullptr;
  }
  return nullptr;
}

/// Builds the chain of models. If a model of the chain has no solution, the builder adds the
/// approximations of this model to the next model of the chain.
class ApproximationChainBuilder {
 public:
  ApproximationChainBuilder(const ComparisonBins& axes, std::span<const Solution> solutions,
                            std::span<const SolutionMarginalDensity> marginals,
                            StateVariable variable)
      : edges_(comparison_bin_edges(undivided_comparison_bins(axes), variable)),
        solutions_(solutions),
        marginals_(marginals),
        variable_(variable),
        smooth_reference_(find_smooth_reference(solutions)) {}

  void append_closure(const Solution& closure, const Marginal& marginal) {
    nodes_.push_back({closure.id(), {}, marginal, 0.0});
  }

  void append_discretised_equation(ModelApproximation approximation, DensityEquation equation,
                                   ImpactCondition impact) {
    pending_approximations_.push_back(approximation);
    for (const auto& s : solutions_) {
      const auto& identity = s.identity;
      if (identity.role != SolutionRole::equation || identity.equation != equation ||
          identity.impact != impact) {
        continue;
      }
      if (const auto* m = usable_marginal(s)) {
        append_model({s.id(), {}, *m, discretisation_error(s)});
        if (equation == DensityEquation::kf && impact == ImpactCondition::map) full_equation_ = &s;
        return;
      }
    }
  }

  void append_grid_limit() {
    pending_approximations_.push_back(ModelApproximation::discretisation);
    if (smooth_reference_ != nullptr || !full_equation_ || !full_equation_->extrapolation) return;
    append_model({full_equation_->id() + std::string(kGridLimitSuffix),
                  {},
                  grid_limit_marginal(*full_equation_),
                  0.0});
  }

  void append_simulation() {
    if (smooth_reference_ == nullptr)
      pending_approximations_.push_back(ModelApproximation::sampling);
    // Without a solution of a density equation, no part of the budget is a discretisation error.
    if (nodes_.size() == 1) std::erase(pending_approximations_, ModelApproximation::discretisation);
    for (const auto& s : solutions_) {
      if (s.identity.role != SolutionRole::simulation || s.identity.equation != DensityEquation::kf)
        continue;
      if (smooth_reference_ != nullptr && &s != smooth_reference_) continue;
      if (const auto* m = usable_marginal(s)) {
        append_model({s.id(),
                      {},
                      *m,
                      std::nullopt,
                      transform::smallest_known_sampling_errors(s),
                      transform::find_smooth_bin_estimate(s, variable_)});
        has_simulation_ = true;
        return;
      }
    }
  }

  std::vector<ModelInApproximationChain> nodes() && {
    return full_equation_ || has_simulation_ ? std::move(nodes_)
                                             : std::vector<ModelInApproximationChain>{};
  }

 private:
  const Marginal* usable_marginal(const Solution& solution) const {
    return solution.has_status_ok() ? find_marginal(marginals_, solution.id(), variable_) : nullptr;
  }

  Marginal grid_limit_marginal(const Solution& solution) const {
    return transform::richardson_limit_marginal(solution, variable_, edges_);
  }

  std::optional<double> discretisation_error(const Solution& s) const {
    if (!s.extrapolation) return std::nullopt;
    return compute_distances(transform::marginal(s, variable_, edges_), grid_limit_marginal(s)).l1;
  }

  void append_model(ModelInApproximationChain node) {
    node.approximations = std::exchange(pending_approximations_, {});
    nodes_.push_back(std::move(node));
  }

  std::vector<double> edges_;
  std::span<const Solution> solutions_;
  std::span<const SolutionMarginalDensity> marginals_;
  StateVariable variable_;
  /// Smooth reference (simulation with control variates), whose smooth bins are the bins of all
  /// marginal densities; null for uniform bins.
  const Solution* smooth_reference_;
  std::vector<ModelInApproximationChain> nodes_;
  std::vector<ModelApproximation> pending_approximations_;
  const Solution* full_equation_ = nullptr;
  bool has_simulation_ = false;
};

}  // namespace

std::vector<ModelInApproximationChain> make_model_chain(
    const ComparisonBins& axes, std::span<const Solution> solutions,
    std::span<const SolutionMarginalDensity> marginals, const Solution& closure,
    StateVariable variable) {
  const Marginal* marginal = find_marginal(marginals, closure.id(), variable);
  if (!marginal) return {};
  const DensityEquation equation = closure.identity.equation.value_or(DensityEquation::kf);
  // A closure with exact reflection of trajectories is a solution with the impact condition `map`.
  const bool to_first_order = closure.identity.impact == ImpactCondition::delta;
  const ImpactCondition impact = to_first_order ? ImpactCondition::delta : ImpactCondition::map;
  ApproximationChainBuilder chain(axes, solutions, marginals, variable);
  chain.append_closure(closure, *marginal);
  chain.append_discretised_equation(ModelApproximation::closure, equation, impact);
  if (to_first_order)
    chain.append_discretised_equation(ModelApproximation::impact, equation, ImpactCondition::map);
  if (equation != DensityEquation::kf) {
    chain.append_discretised_equation(equation == DensityEquation::white
                                          ? ModelApproximation::white_noise
                                          : ModelApproximation::truncation,
                                      DensityEquation::kf, ImpactCondition::map);
  }
  chain.append_grid_limit();
  chain.append_simulation();
  return std::move(chain).nodes();
}

}  // namespace fpkcheck::compare
