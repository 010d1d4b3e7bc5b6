#include "methods/registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/builtin_solvers.hpp"

namespace fpkcheck::methods {
namespace {

using base::NamedParameterValue;
using base::Values;
using transform::Solution;
using transform::SolutionIdentity;

bool is_id_in_family(std::string_view id, const std::string& family) {
  return id == family || id.starts_with(family + '-');
}

Values with_overrides(Values options, const Values& overrides) {
  for (const auto& [name, value] : overrides) {
    const auto entry = std::ranges::find(options, name, &NamedParameterValue::name);
    if (entry != options.end()) entry->value = value;
  }
  return options;
}

constexpr std::string_view kAllMethods = "all";

// Returns the default ids of a family, of a solver or, for the item `all`, of all solvers; otherwise
// the item itself.
std::vector<std::string> method_ids_of_item(const SolverRegistry& registry,
                                            const std::string& item) {
  std::vector<std::string> ids;
  for (const auto& solver : registry.solvers()) {
    for (const auto& family : solver.families) {
      if (family.name != item && solver.name != item && item != kAllMethods) continue;
      ids.insert(ids.end(), family.default_ids.begin(), family.default_ids.end());
    }
  }
  if (ids.empty()) ids.push_back(item);
  return ids;
}

}  // namespace

void SolverRegistry::add_solver(Solver solver) {
  if (find_solver(solver.name) != nullptr) {
    throw std::logic_error("solver '" + std::string(solver.name) + "' is registered twice");
  }
  const auto known = method_families_by_trust();
  for (const auto& family : solver.families) {
    if (std::ranges::find(known, family.name, &MethodFamily::name) != known.end()) {
      throw std::logic_error("methods '" + family.name + "' are registered twice");
    }
  }
  solvers_.push_back(std::move(solver));
}

const Solver* SolverRegistry::find_solver(std::string_view name) const {
  const auto found = std::ranges::find(solvers_, name, &Solver::name);
  return found == solvers_.end() ? nullptr : &*found;
}

std::vector<const MethodFamily*> SolverRegistry::method_families_by_trust() const {
  std::vector<const MethodFamily*> all;
  for (const auto& solver : solvers_) {
    for (const auto& family : solver.families) all.push_back(&family);
  }
  std::ranges::stable_sort(all, {}, [](const MethodFamily* family) { return family->role; });
  return all;
}

void SolverRegistry::set_missing_identity_fields(SolutionIdentity& identity) const {
  const auto all = method_families_by_trust();
  const auto entry = std::ranges::find_if(
      all, [&](const MethodFamily* family) { return is_id_in_family(identity.id, family->name); });
  if (entry == all.end()) return;
  const MethodFamily& family = **entry;
  identity.role = family.role;
  identity.family = family.name;
  identity.meaning = family.meaning;
  // Trust in a method increases with the index of the family. Within a family of methods, trust
  // increases with the closure order, or with the index among the default ids.
  constexpr int kMaxFamilySize = 1000;
  const auto place =
      std::ranges::find(family.default_ids, identity.id) - family.default_ids.begin();
  identity.trust = static_cast<int>(entry - all.begin()) * kMaxFamilySize +
                   identity.order.value_or(static_cast<int>(place));
  identity.plot_style = family.plot_style(identity);
}

Method SolverRegistry::make_method(const Solver& solver, const Values& options) const {
  Method method = solver.method(options);
  set_missing_identity_fields(method.identity);
  return method;
}

std::optional<Method> SolverRegistry::find_method_by_id(std::string_view id,
                                                        const Values& overrides) const {
  for (const auto& solver : solvers_) {
    if (const auto options = solver.options_of(id)) {
      return make_method(solver, with_overrides(*options, overrides));
    }
  }
  return std::nullopt;
}

std::string SolverRegistry::default_method_list() const {
  std::vector<std::string> names;
  for (const Solver& solver : solvers_) {
    if (solver.in_default_runs) names.push_back(solver.name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

std::vector<Method> SolverRegistry::methods_selected_by_list(const std::string& list,
                                                             const Values& overrides) const {
  std::map<std::string, Method> methods;
  std::istringstream items(list);
  for (std::string item; std::getline(items, item, ',');) {
    for (const auto& id : method_ids_of_item(*this, item)) {
      auto found = find_method_by_id(id, overrides);
      if (!found) {
        throw InputError(fmt::format("--methods: unknown method {}; use {}", base::in_quotes(item),
                                     selectable_methods_text(*this)));
      }
      methods.emplace(found->id(), std::move(*found));
    }
  }
  if (methods.empty()) {
    throw InputError(fmt::format("--methods: the list is empty; use {}, separated by commas",
                                 selectable_methods_text(*this)));
  }
  std::vector<Method> ordered;
  for (auto& [id, method] : methods) ordered.push_back(std::move(method));
  std::ranges::stable_sort(ordered, is_less_trusted, &Method::identity);
  return ordered;
}

std::optional<Method> SolverRegistry::method_for_solution(const Solution& solution,
                                                          const Values& overrides) const {
  const auto& identity = solution.identity;
  if (transform::is_external(identity)) return std::nullopt;
  const Solver* solver = find_solver(identity.method);
  if (solver == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : solvers_) names.push_back(known.name);
    throw InputError(fmt::format("unknown method {}: must be {} or {}",
                                 base::in_quotes(identity.method), fmt::join(names, ", "),
                                 transform::kExternalFile));
  }
  Method made = make_method(*solver, with_overrides(solution.options, overrides));
  if (made.id() != identity.id) {
    throw InputError(fmt::format("the options belong to {}; run again", made.id()));
  }
  return made;
}

void SolverRegistry::set_missing_identity_fields_of_run(results::Run& run) const {
  for (auto& one : run.cases) {
    for (auto& solution : one.solutions) {
      if (!solution.identity.family.empty()) continue;
      if (const auto method = find_method_by_id(solution.id()))
        solution.identity = method->identity;
    }
  }
}

bool is_less_trusted(const SolutionIdentity& first, const SolutionIdentity& second) {
  return std::tie(first.role, first.trust, first.id) <
         std::tie(second.role, second.trust, second.id);
}

std::string selectable_methods_text(const SolverRegistry& registry) {
  std::vector<std::string> names, examples;
  for (const auto& solver : registry.solvers()) {
    names.push_back(solver.name);
    for (const auto& family : solver.families) {
      if (!family.default_ids.empty()) examples.push_back(family.default_ids.back());
    }
  }
  return fmt::format("{}, {}, or ids such as {}", kAllMethods, fmt::join(names, ", "),
                     fmt::join(examples, ", "));
}

SolverRegistry builtin_registry() {
  SolverRegistry registry;
  for (const auto& solver : kBuiltinSolvers) registry.add_solver(solver());
  return registry;
}

}  // namespace fpkcheck::methods
