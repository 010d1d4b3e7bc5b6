#include "problem/parameter_derivative.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::problem {
namespace {

// Returns the numeric value of a parameter in the sections of a case; null if the case lacks the
// parameter.
double* find_parameter_value(std::vector<CaseFileSection>& sections, const std::string& parameter) {
  for (CaseFileSection& section : sections) {
    for (auto& [name, value] : section.values) {
      if (section.name + '.' + name == parameter) return std::get_if<double>(&value);
    }
  }
  return nullptr;
}

// Returns the problem with a changed value of a parameter; nullopt if the changed value is invalid.
std::optional<Problem> with_parameter_value(const Problem& problem, const std::string& parameter,
                                            double value) {
  auto changed = case_file_sections(problem);
  *find_parameter_value(changed, parameter) = value;
  try {
    return problem_from_sections(problem.name, changed);
  } catch (const InputError&) {
    return std::nullopt;  // the value is out of the range of the parameter
  }
}

}  // namespace

std::vector<std::string> differentiable_parameters(const Problem& problem) {
  std::vector<std::string> keys;
  for (const ReportedParameter& p : parameters_for_reports(problem)) {
    const bool is_position = p.section == "wall" && (p.name == "left" || p.name == "right");
    const std::string key = p.section + '.' + p.name;
    if (!p.is_default && !is_position && std::holds_alternative<double>(p.value)) {
      keys.push_back(key);
    }
  }
  return keys;
}

ParameterDifferenceQuotient parameter_difference_quotient(const Problem& problem,
                                                          const std::string& parameter,
                                                          double relative_step) {
  auto all = case_file_sections(problem);
  const double* value = find_parameter_value(all, parameter);
  if (value == nullptr || parameter == "wall.left" || parameter == "wall.right") {
    throw InputError(fmt::format("{} is no parameter with a derivative; use some of {}",
                                 base::in_quotes(parameter),
                                 fmt::join(differentiable_parameters(problem), ", ")));
  }
  ParameterDifferenceQuotient derivative{parameter, *value, {}};
  const double widest = relative_step * (*value == 0 ? 1 : std::abs(*value));
  double step = widest;
  const auto at = [&](double steps) {
    return with_parameter_value(problem, parameter, *value + steps * step);
  };
  // Since a function of a parameter may change strongly close to an end of the parameter's range,
  // the step of the difference quotient is at most about a quarter of the distance from the
  // parameter value to the end of the range.
  constexpr int kMostHalvings = 5;
  for (int n = 0; n < kMostHalvings && (!at(4) || !at(-4)); ++n) step /= 2;
  if (!at(1) || !at(-1)) step = widest;
  auto above = at(1), below = at(-1);
  if (above && below) {
    derivative.terms = {{1 / (2 * step), std::move(*above)}, {-1 / (2 * step), std::move(*below)}};
    return derivative;
  }
  // One-sided difference quotient F' ~ +-(-3 F(0) + 4 F(1) - F(2)) / (2 step) of a function F,
  // towards larger or smaller parameter values
  for (const double sign : {1.0, -1.0}) {
    auto first = at(sign), second = at(2 * sign);
    if (!first || !second) continue;
    const double unit = sign / (2 * step);
    derivative.terms = {
        {-3 * unit, problem}, {4 * unit, std::move(*first)}, {-unit, std::move(*second)}};
    return derivative;
  }
  throw InputError(fmt::format("{} = {:g} has no derivative: the problem is invalid on both sides",
                               parameter, *value));
}

}  // namespace fpkcheck::problem
