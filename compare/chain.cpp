#include "compare/chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/smooth_reference.hpp"

namespace fpkcheck::compare {
namespace {

using problem::Equation;
using problem::Impact;
using transform::Marginal;
using transform::Role;
using transform::Solution;
using transform::Variable;

const Marginal* find_marginal(std::span<const SolutionMarginal> marginals, const std::string& id,
                              Variable variable) {
  for (const auto& candidate : marginals) {
    if (candidate.solution != id || candidate.variable != variable) continue;
    const bool finite =
        std::ranges::all_of(candidate.marginal.density, [](double p) { return std::isfinite(p); });
    return finite ? &candidate.marginal : nullptr;
  }
  return nullptr;
}

/// Builds a chain of models, model by model. Collects the approximations since the last model that
/// was appended, for the next model.
class Chain {
 public:
  Chain(const ComparisonAxes& axes, std::span<const Solution> solutions,
        std::span<const SolutionMarginal> marginals, Variable variable)
      : edges_(edges(uniform_axes(axes), variable)),
        solutions_(solutions),
        marginals_(marginals),
        variable_(variable),
        smooth_reference_(find_smooth_reference(solutions)) {}

  void begin(const Solution& closure, const Marginal& marginal) {
    nodes_.push_back({closure.id(), {}, marginal, 0.0});
  }

  void append_discretised_equation(Link link, Equation equation, Impact impact) {
    pending_.push_back(link);
    for (const auto& s : solutions_) {
      const auto& identity = s.identity;
      if (identity.role != Role::equation || identity.equation != equation ||
          identity.impact != impact) {
        continue;
      }
      if (const auto* m = usable_marginal(s)) {
        append({s.id(), {}, *m, discretisation_error(s)});
        if (equation == Equation::kf && impact == Impact::map) full_equation_ = &s;
        return;
      }
    }
  }

  void limit() {
    pending_.push_back(Link::discretisation);
    if (smooth_reference_ != nullptr || !full_equation_ || !full_equation_->extrapolation) return;
    append(
        {full_equation_->id() + std::string(kGridLimitSuffix), {}, limit_of(*full_equation_), 0.0});
  }

  void simulation() {
    if (smooth_reference_ == nullptr) pending_.push_back(Link::sampling);
    // Without a solution of a density equation, no part of the budget is a discretisation error.
    if (nodes_.size() == 1) std::erase(pending_, Link::discretisation);
    for (const auto& s : solutions_) {
      if (s.identity.role != Role::simulation || s.identity.equation != Equation::kf) continue;
      if (smooth_reference_ != nullptr && &s != smooth_reference_) continue;
      if (const auto* m = usable_marginal(s)) {
        append({s.id(),
                {},
                *m,
                std::nullopt,
                transform::best_sampling_error(s),
                transform::smooth_estimate(s, variable_)});
        has_simulation_ = true;
        return;
      }
    }
  }

  std::vector<ChainNode> nodes() && {
    return full_equation_ || has_simulation_ ? std::move(nodes_) : std::vector<ChainNode>{};
  }

 private:
  const Marginal* usable_marginal(const Solution& solution) const {
    return solution.is_ok() ? find_marginal(marginals_, solution.id(), variable_) : nullptr;
  }

  Marginal limit_of(const Solution& solution) const {
    return transform::limit_marginal(solution, variable_, edges_);
  }

  std::optional<double> discretisation_error(const Solution& s) const {
    if (!s.extrapolation) return std::nullopt;
    return distances(transform::marginal(s, variable_, edges_), limit_of(s)).l1;
  }

  void append(ChainNode node) {
    node.links = std::exchange(pending_, {});
    nodes_.push_back(std::move(node));
  }

  std::vector<double> edges_;
  std::span<const Solution> solutions_;
  std::span<const SolutionMarginal> marginals_;
  Variable variable_;
  /// Smooth reference, whose smooth bins are the bins of all marginals; null if there is none.
  const Solution* smooth_reference_;
  std::vector<ChainNode> nodes_;
  std::vector<Link> pending_;
  const Solution* full_equation_ = nullptr;
  bool has_simulation_ = false;
};

}  // namespace

std::vector<ChainNode> model_chain(const ComparisonAxes& axes, std::span<const Solution> solutions,
                                   std::span<const SolutionMarginal> marginals,
                                   const Solution& closure, Variable variable) {
  const Marginal* marginal = find_marginal(marginals, closure.id(), variable);
  if (!marginal) return {};
  const Equation equation = closure.identity.equation.value_or(Equation::kf);
  // A closure that reflects trajectories exactly solves the equation with the impact condition
  // `map`.
  const bool to_first_order = closure.identity.impact == Impact::delta;
  const Impact impact = to_first_order ? Impact::delta : Impact::map;
  Chain chain(axes, solutions, marginals, variable);
  chain.begin(closure, *marginal);
  chain.append_discretised_equation(Link::closure, equation, impact);
  if (to_first_order) chain.append_discretised_equation(Link::impact, equation, Impact::map);
  if (equation != Equation::kf) {
    chain.append_discretised_equation(
        equation == Equation::white ? Link::white_noise : Link::truncation, Equation::kf,
        Impact::map);
  }
  chain.limit();
  chain.simulation();
  return std::move(chain).nodes();
}

}  // namespace fpkcheck::compare
