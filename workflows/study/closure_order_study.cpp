#include "workflows/study/closure_order_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include "base/input_error.hpp"
#include "compare/pair_distances.hpp"
#include "workflows/study/method_variants.hpp"

namespace fpkcheck::study {
namespace {

using methods::Method;
using methods::SolverRegistry;
using transform::StateVariable;

Method reference_method(const SolverRegistry& registry) {
  std::vector<Method> candidates;
  for (auto& variant : method_variants(registry, transform::SolutionRole::equation)) {
    if (variant.is_default_variant && variant.solves_full_problem())
      candidates.push_back(std::move(variant.first));
  }
  if (candidates.empty()) {
    throw InputError(
        "no reference for the closures: no discretisation of the full problem is registered");
  }
  return *std::ranges::max_element(candidates, methods::is_less_trusted, &Method::identity);
}

const MethodVariant& find_formulation(const std::string& name,
                                      const std::vector<MethodVariant>& all) {
  const auto found = std::ranges::find(all, name, &MethodVariant::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const auto& known : all) names.push_back(known.name);
  throw InputError(fmt::format("--formulations: '{}' is no formulation; use some of {}", name,
                               fmt::join(names, ", ")));
}

std::vector<MethodVariant> closure_variants(const SolverRegistry& registry) {
  auto all = method_variants(registry, transform::SolutionRole::closure);
  std::erase_if(all, [](const MethodVariant& variant) { return !variant.identity().order; });
  return all;
}

// Largest accepted error, so large that no closure has the status `inaccurate`, and the study shows
// all closures.
constexpr double kUnlimitedError = 10;

Method closure_of_order(const SolverRegistry& registry, const MethodVariant& formulation,
                        int order) {
  const std::string id = fmt::format("{}-n{}", formulation.stem, order);
  auto method = registry.find_method_by_id(id, {{"accuracy", kUnlimitedError}});
  if (!method)
    throw InputError(fmt::format("--orders {}: there is no {}; leave this order out", order, id));
  return std::move(*method);
}

void set_reference_distances(const std::vector<compare::SolutionPairDistances>& pairs,
                             const std::string& reference, ClosureOrderStudyRow& row) {
  // The density tail in an order study is the decade 1e-5 .. 1e-4 of the reference density.
  constexpr double kTailStart = 1e-5;
  const std::string& id = row.solution.id();
  const auto y = compare::l1_distance_between(pairs, id, reference, StateVariable::y);
  const auto ydot = compare::l1_distance_between(pairs, id, reference, StateVariable::ydot);
  if (y && ydot) row.l1 = {*y, *ydot};
  for (const auto variable : transform::kVariables) {
    const auto* pair = compare::find_pair_distances(pairs, id, reference, variable);
    if (pair == nullptr) continue;
    for (const auto& decade : pair->distances.log10_tail) {
      const bool is_tail_decade = std::abs(decade.from / kTailStart - 1) < 1e-6;
      if (!is_tail_decade || !std::isfinite(decade.mean_abs)) continue;
      (variable == StateVariable::y ? row.tail_y : row.tail_ydot) = decade.mean_abs;
    }
  }
}

bool boolean_metric(const transform::Metrics& metrics, const std::string& path) {
  const auto* found = transform::find_metric(metrics, path);
  const auto* value = found == nullptr ? nullptr : std::get_if<bool>(&found->value);
  return value != nullptr && *value;
}

}  // namespace

std::optional<SolutionBranch> read_solution_branch(const transform::Metrics& metrics) {
  const auto end = transform::metric_text(metrics, "branch.end");
  const auto largest_fraction = transform::metric_number(metrics, "branch.furthest");
  if (!end || !largest_fraction) return std::nullopt;
  SolutionBranch branch{*end, *largest_fraction, {}};
  for (;;) {
    const std::string path = fmt::format("branch.points[{}].", branch.points.size());
    const auto fraction = transform::metric_number(metrics, path + "fraction");
    const auto norm = transform::metric_number(metrics, path + "norm");
    if (!fraction || !norm) return branch;
    branch.points.push_back({*fraction, *norm, boolean_metric(metrics, path + "fold")});
  }
}

std::vector<std::string> closure_formulations(const SolverRegistry& registry) {
  std::vector<std::string> names;
  for (const auto& formulation : closure_variants(registry)) names.push_back(formulation.name);
  return names;
}

ClosureOrderStudy study_closure_orders(const problem::Problem& problem,
                                       const ClosureOrderStudyOptions& options,
                                       const SolverRegistry& registry,
                                       const methods::ProgressListener& listener) {
  const std::set<int> orders(options.orders.begin(), options.orders.end());
  const auto known = closure_variants(registry);
  ClosureOrderStudy study{problem, {}, {}};
  std::vector<Method> methods;
  for (const auto& name : options.formulations) {
    const MethodVariant& formulation = find_formulation(name, known);
    const bool must_converge = formulation.is_default_variant && formulation.solves_full_problem();
    for (const int order : orders) {
      methods.push_back(closure_of_order(registry, formulation, order));
      study.rows.push_back({formulation.name, order, must_converge, {}});
    }
  }
  methods.push_back(reference_method(registry));
  auto found = methods::run_cases({problem}, methods, 1, listener).front();
  study.reference = std::move(found.solutions.back());
  for (std::size_t k = 0; k < study.rows.size(); ++k) {
    study.rows[k].solution = std::move(found.solutions[k]);
    set_reference_distances(found.pairs, study.reference.id(), study.rows[k]);
  }
  return study;
}

bool has_converged(const ClosureOrderStudy& study) {
  return study.reference.has_status_ok() &&
         std::ranges::all_of(study.rows, [](const ClosureOrderStudyRow& row) {
           return row.solution.has_status_ok() || !row.must_converge;
         });
}

}  // namespace fpkcheck::study
