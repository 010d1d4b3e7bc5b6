#include "workflows/study/order.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include "base/input_error.hpp"
#include "compare/pairs.hpp"
#include "workflows/study/kinds.hpp"

namespace fpkcheck::study {
namespace {

using methods::Method;
using methods::Registry;
using transform::Variable;

Method reference_method(const Registry& registry) {
  std::vector<Method> candidates;
  for (auto& kind : kinds(registry, transform::Role::equation)) {
    if (kind.usual && kind.solves_the_problem()) candidates.push_back(std::move(kind.first));
  }
  if (candidates.empty()) {
    throw InputError(
        "no reference for the closures: no discretisation of the full problem is registered");
  }
  return *std::ranges::max_element(candidates, methods::less_trusted, &Method::identity);
}

const Kind& formulation_named(const std::string& name, const std::vector<Kind>& all) {
  const auto found = std::ranges::find(all, name, &Kind::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const auto& known : all) names.push_back(known.name);
  throw InputError(fmt::format("--formulations: '{}' is no formulation; use some of {}", name,
                               fmt::join(names, ", ")));
}

std::vector<Kind> closures(const Registry& registry) {
  auto all = kinds(registry, transform::Role::closure);
  std::erase_if(all, [](const Kind& kind) { return !kind.identity().order; });
  return all;
}

// L1 error that every closure satisfies: the study shows the errors, whatever their size.
constexpr double kAnyError = 10;

Method at_order(const Registry& registry, const Kind& formulation, int order) {
  const std::string id = fmt::format("{}-n{}", formulation.stem, order);
  auto method = registry.by_id(id, {{"accuracy", kAnyError}});
  if (!method)
    throw InputError(fmt::format("--orders {}: there is no {}; leave this order out", order, id));
  return std::move(*method);
}

void add_distances(const std::vector<compare::PairDistances>& pairs, const std::string& reference,
                   OrderRow& row) {
  constexpr double kTailFrom = 1e-5;  // the tail: this decade of the reference density
  const std::string& id = row.solution.id();
  const auto y = compare::l1_between(pairs, id, reference, Variable::y);
  const auto ydot = compare::l1_between(pairs, id, reference, Variable::ydot);
  if (y && ydot) row.l1 = {*y, *ydot};
  for (const auto variable : transform::kVariables) {
    const auto* pair = compare::find_pair(pairs, id, reference, variable);
    if (pair == nullptr) continue;
    for (const auto& decade : pair->distances.log10_tail) {
      const bool looked_at = std::abs(decade.from / kTailFrom - 1) < 1e-6;
      if (!looked_at || !std::isfinite(decade.mean_abs)) continue;
      (variable == Variable::y ? row.tail_y : row.tail_ydot) = decade.mean_abs;
    }
  }
}

bool flag(const transform::Observations& observations, const std::string& path) {
  const auto* found = transform::find(observations, path);
  const auto* value = found == nullptr ? nullptr : std::get_if<bool>(&found->value);
  return value != nullptr && *value;
}

}  // namespace

std::optional<Branch> branch(const transform::Observations& observations) {
  const auto end = transform::word(observations, "branch.end");
  const auto furthest = transform::number(observations, "branch.furthest");
  if (!end || !furthest) return std::nullopt;
  Branch branch{*end, *furthest, {}};
  for (;;) {
    const std::string path = fmt::format("branch.points[{}].", branch.points.size());
    const auto fraction = transform::number(observations, path + "fraction");
    const auto norm = transform::number(observations, path + "norm");
    if (!fraction || !norm) return branch;
    branch.points.push_back({*fraction, *norm, flag(observations, path + "fold")});
  }
}

std::vector<std::string> formulations(const Registry& registry) {
  std::vector<std::string> names;
  for (const auto& formulation : closures(registry)) names.push_back(formulation.name);
  return names;
}

OrderStudy study_orders(const problem::Problem& problem, const OrderStudyOptions& options,
                        const Registry& registry, const methods::ProgressListener& listener) {
  const std::set<int> orders(options.orders.begin(), options.orders.end());
  const auto known = closures(registry);
  OrderStudy study{problem, {}, {}};
  std::vector<Method> methods;
  for (const auto& name : options.formulations) {
    const Kind& formulation = formulation_named(name, known);
    const bool to_converge = formulation.usual && formulation.solves_the_problem();
    for (const int order : orders) {
      methods.push_back(at_order(registry, formulation, order));
      study.rows.push_back({formulation.name, order, to_converge, {}});
    }
  }
  methods.push_back(reference_method(registry));
  auto found = methods::run_cases({problem}, methods, 1, listener).front();
  study.reference = std::move(found.solutions.back());
  for (std::size_t k = 0; k < study.rows.size(); ++k) {
    study.rows[k].solution = std::move(found.solutions[k]);
    add_distances(found.pairs, study.reference.id(), study.rows[k]);
  }
  return study;
}

bool reached(const OrderStudy& study) {
  return study.reference.is_ok() && std::ranges::all_of(study.rows, [](const OrderRow& row) {
           return row.solution.is_ok() || !row.to_converge;
         });
}

}  // namespace fpkcheck::study
