#include "methods/external/form_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/json_values.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::methods {
namespace {

epc::ClosedForm form_of(const transform::Metrics& metrics, const std::string& where) {
  try {
    return epc::read_closed_form(metrics);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", where, error.what()));
  }
}

FormFile form_of_run(const results::Run& run, const std::string& where,
                     const SolutionChoice& choice) {
  std::vector<std::string> cases;
  for (const auto& one : run.cases) cases.push_back(one.name());
  auto asked = choice.case_name;
  if (!asked && std::ranges::find(cases, choice.usual_case) != cases.end()) {
    asked = choice.usual_case;
  }
  const auto& one = run.cases[chosen(cases, asked, "case", where)];

  std::vector<std::string> with_form;
  for (const auto& solution : one.solutions) {
    if (epc::has_closed_form(solution.metrics)) with_form.push_back(solution.id());
  }
  if (choice.solution && one.find(*choice.solution) != nullptr &&
      std::ranges::find(with_form, *choice.solution) == with_form.end()) {
    throw InputError(fmt::format(
        "{}: {} has no closed form in {}{}", where, base::in_quotes(*choice.solution), one.name(),
        with_form.empty() ? "" : fmt::format("; use {}", fmt::join(with_form, ", "))));
  }
  const std::string of_case = fmt::format("{}, {}", where, base::sanitise(one.name()));
  const auto& solution =
      *one.find(with_form[chosen(with_form, choice.solution, "solution", of_case)]);
  return {form_of(solution.metrics, fmt::format("{}: {}", where, solution.id())), one.problem,
          solution};
}

}  // namespace

std::size_t chosen(const std::vector<std::string>& names, const std::optional<std::string>& asked,
                   const std::string& what, const std::string& where) {
  if (names.empty()) {
    throw InputError(fmt::format("{} contains no {} with a density of this kind", where, what));
  }
  std::vector<std::string> known;
  for (const auto& name : names) known.push_back(base::sanitise(name));
  if (!asked) {
    if (names.size() == 1) return 0;
    throw InputError(fmt::format("{} contains {} {}s; select one by {}=: {}", where, names.size(),
                                 what, what, fmt::join(known, ", ")));
  }
  const auto found = std::ranges::find(names, *asked);
  if (found == names.end()) {
    throw InputError(fmt::format("{} contains no {} {}; use {}", where, what,
                                 base::in_quotes(*asked), fmt::join(known, ", ")));
  }
  return static_cast<std::size_t>(found - names.begin());
}

FormFile read_form(const std::string& text, const std::string& where,
                   const SolutionChoice& choice) {
  if (results::is_summary(text, where)) {
    std::istringstream in(text);
    return form_of_run(results::read_summary(in, where), where, choice);
  }
  if (choice.solution || choice.case_name) {
    throw InputError(fmt::format("{} contains a single closed form; omit the key {}", where,
                                 choice.solution ? "solution" : "case"));
  }
  return {form_of(results::values_in_json(text, where), where), {}, {}};
}

}  // namespace fpkcheck::methods
