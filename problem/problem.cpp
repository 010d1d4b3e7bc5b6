#include "problem/problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "parameters/input_error.hpp"

namespace fpkcheck::problem {
namespace {

using parameters::Values;

const Values& values_of(const std::vector<Section>& sections, const std::string& name) {
  const auto found = std::ranges::find(sections, name, &Section::name);
  if (found == sections.end()) {
    throw InputError(
        fmt::format("{} is missing (of another version of the program? run again)", name));
  }
  return found->values;
}

std::string number_text(const parameters::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:g}", *number) : std::get<std::string>(value);
}

}  // namespace

std::vector<Section> sections(const Problem& problem) {
  return {{"system", system_description().values(problem.system.coefficients())},
          {"impulse", impulse_description().values(problem.impulses.parameters())}};
}

Problem problem_from(const std::string& name, const std::vector<Section>& sections) {
  return {name, System(system_description().read(values_of(sections, "system"), "system")),
          ImpulseTrain(impulse_description().read(values_of(sections, "impulse"), "impulse"))};
}

std::vector<ShownParameter> shown_parameters(const Problem& problem) {
  std::vector<ShownParameter> shown;
  const auto add = [&](const Section& section, const parameters::Descriptions& description) {
    for (const auto& [name, value] : section.values) {
      const auto& parameter = *description.find(name);
      shown.push_back({section.name, name, parameter.symbol, parameter.typeset, parameter.help,
                       value, parameter.fallback == value});
    }
  };
  const auto all = sections(problem);
  add(all[0], system_description());
  add(all[1], impulse_description());
  return shown;
}

std::string parameters_text(const Problem& problem, bool typeset) {
  std::vector<std::string> of_system, of_impulses;
  for (const auto& p : shown_parameters(problem)) {
    if (p.usual) continue;
    auto& part = p.section == "system" ? of_system : of_impulses;
    const auto& symbol = typeset ? p.typeset : p.symbol;
    if (symbol.empty()) {
      part.insert(part.begin(), fmt::format("{} impulses", number_text(p.value)));
    } else {
      part.push_back(fmt::format("{} = {}", symbol, number_text(p.value)));
    }
  }
  return fmt::format("{}; {}", fmt::join(of_system, ", "), fmt::join(of_impulses, ", "));
}

}  // namespace fpkcheck::problem
