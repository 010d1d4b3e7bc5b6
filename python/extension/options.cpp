#include "extension/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::python {
namespace {

using base::NamedParameterValue;
using base::Value;
using base::Values;

// Returns the name of an option without the prefix of the solver; empty if the solver has no such
// option.
std::optional<std::string> option_name(const methods::Solver& solver, const std::string& option) {
  const auto dot = option.find('.');
  if (dot != std::string::npos && option.substr(0, dot) != solver.name) return std::nullopt;
  auto name = dot == std::string::npos ? option : option.substr(dot + 1);
  if (solver.option_descriptions->find(name) == nullptr) return std::nullopt;
  return name;
}

void require_known(const methods::SolverRegistry& registry, const std::string& option) {
  std::vector<std::string> known;
  for (const auto& solver : registry.solvers()) {
    if (option_name(solver, option)) return;
    if (option.find('.') != std::string::npos && !option.starts_with(solver.name + '.')) continue;
    for (const auto& parameter : solver.option_descriptions->parameters()) {
      known.push_back(solver.name + '.' + parameter.name);
    }
  }
  if (known.empty()) {
    for (const auto& solver : registry.solvers()) known.push_back(solver.name + ".NAME");
  }
  throw InputError(fmt::format("options: unknown option {}; use {}", base::in_quotes(option),
                               fmt::join(known, ", ")));
}

Value convert_value(const base::Parameter& parameter, const NamedParameterValue& option) {
  const std::string label = fmt::format("options: {} =", base::to_printable_text(option.name));
  if (const auto* text = std::get_if<std::string>(&option.value)) {
    return parse_value(parameter, *text, label);
  }
  const auto value = parameter.convert_to_parameter_type(option.value);
  if (!value) {
    throw InputError(fmt::format("{} {} (must be {})", label, base::value_as_text(option.value),
                                 parameter.requirement_text()));
  }
  return *value;
}

methods::Method replace_options(const methods::SolverRegistry& registry,
                                const methods::Method& method, const Values& options) {
  const methods::Solver& solver = *registry.find_solver(method.identity.method);
  Values replaced = method.options;
  for (const auto& option : options) {
    const auto name = option_name(solver, option.name);
    if (!name) continue;
    const Value value = convert_value(*solver.option_descriptions->find(*name), option);
    const auto entry = std::ranges::find(replaced, *name, &NamedParameterValue::name);
    if (entry != replaced.end()) entry->value = value;
  }
  auto made = registry.make_method(solver, replaced);
  if (made.id() != method.id()) {
    throw InputError(
        fmt::format("options: these values select {0} in place of {1}; list {0} in methods",
                    made.id(), method.id()));
  }
  return made;
}

}  // namespace

std::vector<methods::Method> methods_selected_by_list(const methods::SolverRegistry& registry,
                                                      const std::string& list,
                                                      const Values& options) {
  for (const auto& option : options) require_known(registry, option.name);
  auto methods = registry.methods_selected_by_list(list, {});
  for (auto& method : methods) method = replace_options(registry, method, options);
  return methods;
}

}  // namespace fpkcheck::python
