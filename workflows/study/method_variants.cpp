#include "workflows/study/method_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "base/input_error.hpp"

namespace fpkcheck::study {
namespace {

using methods::Method;
using methods::SolverRegistry;
using problem::DensityEquation;
using problem::ImpactCondition;
using transform::SolutionIdentity;
using transform::SolutionRole;

// Returns the method with the given id and options from a registry; empty for an unknown id or an
// invalid option.
std::optional<Method> find_method(const SolverRegistry& registry, const std::string& id,
                                  const base::Values& given = {}) {
  try {
    return registry.find_method_by_id(id, given);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// Returns the default methods of a family, then the variants that differ from a default method by
// one option.
std::vector<Method> family_members_and_variants(const SolverRegistry& registry,
                                                const methods::Solver& solver,
                                                const std::vector<std::string>& usual) {
  std::vector<Method> found;
  const auto add = [&](std::optional<Method> method) {
    if (method) found.push_back(std::move(*method));
  };
  for (const auto& id : usual) add(registry.find_method_by_id(id));
  for (const auto& id : usual) {
    for (const auto& parameter : solver.option_descriptions->parameters()) {
      for (const auto& choice : parameter.choices) {
        add(find_method(registry, id, {{parameter.name, choice}}));
      }
    }
  }
  return found;
}

std::string id_stem(const SolutionIdentity& identity) {
  const std::string end = identity.order ? fmt::format("-n{}", *identity.order) : "";
  return identity.id.substr(0, identity.id.size() - (identity.id.ends_with(end) ? end.size() : 0));
}

// The impact condition of a simulation is exact, and therefore equivalent to `map`.
bool solves_equation(const SolutionIdentity& identity, DensityEquation equation,
                     ImpactCondition impact) {
  return identity.equation == equation && identity.impact &&
         (*identity.impact == ImpactCondition::delta) == (impact == ImpactCondition::delta);
}

}  // namespace

bool MethodVariant::solves_full_problem() const {
  return solves_equation(identity(), DensityEquation::kf, ImpactCondition::map);
}

std::vector<MethodVariant> method_variants(const SolverRegistry& registry, SolutionRole role) {
  std::vector<MethodVariant> all;
  const auto known = [&](const std::string& stem) {
    return std::ranges::find(all, stem, &MethodVariant::stem) != all.end();
  };
  for (const auto& solver : registry.solvers()) {
    for (const auto& family : solver.families) {
      if (family.role != role) continue;
      for (auto& method : family_members_and_variants(registry, solver, family.default_ids)) {
        const std::string stem = id_stem(method.identity), prefix = solver.name + '-';
        if (method.identity.family != family.name || known(stem)) continue;
        const bool is_first_solver = all.empty() || all.front().identity().method == solver.name;
        const bool is_shortened = is_first_solver && stem.starts_with(prefix);
        std::string name = is_shortened ? stem.substr(prefix.size()) : stem;
        const bool is_default_variant =
            std::ranges::find(family.default_ids, method.id()) != family.default_ids.end();
        all.push_back({std::move(name), stem, is_default_variant, std::move(method)});
      }
    }
  }
  return all;
}

std::vector<Method> methods_compared_with_grids(const SolverRegistry& registry,
                                                DensityEquation equation, ImpactCondition impact,
                                                const base::Values& simulation) {
  std::vector<Method> all;
  std::set<std::string> families;  // families that have a variant in `all`
  for (const auto& variant : method_variants(registry, SolutionRole::closure)) {
    const SolutionIdentity& identity = variant.identity();
    const bool approximates_full_problem = variant.is_default_variant &&
                                           equation == DensityEquation::kf &&
                                           impact != ImpactCondition::delta;
    if (!approximates_full_problem && !solves_equation(identity, equation, impact)) continue;
    if (!variant.is_default_variant && families.contains(identity.family)) continue;
    families.insert(identity.family);
    if (!identity.order) all.push_back(variant.first);
    const int highest = !identity.order ? 0 : identity.impact == ImpactCondition::delta ? 6 : 12;
    for (int n = 2; n <= highest; n += 2) {
      if (auto method = find_method(registry, fmt::format("{}-n{}", variant.stem, n))) {
        all.push_back(std::move(*method));
      }
    }
  }
  for (const auto& variant : method_variants(registry, SolutionRole::simulation)) {
    if (!solves_equation(variant.identity(), equation, impact)) continue;
    all.push_back(*registry.find_method_by_id(variant.stem, simulation));
  }
  std::ranges::stable_sort(all, methods::is_less_trusted, &Method::identity);
  return all;
}

}  // namespace fpkcheck::study
