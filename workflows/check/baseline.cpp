#include "workflows/check/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "results/saved_run.hpp"
#include "workflows/check/case_quantities.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {
namespace {

namespace fs = std::filesystem;
using transform::Solution;

// Removes an external density, which `fpkcheck check` cannot compute again, and all results about
// this density.
void remove_solution(results::CaseResult& case_result, const std::string& id) {
  std::erase_if(case_result.solutions, [&](const auto& solution) { return solution.id() == id; });
  std::erase_if(case_result.pairs, [&](const auto& pair) { return pair.a == id || pair.b == id; });
  std::erase_if(case_result.budget, [&](const auto& row) { return row.solution == id; });
  std::erase_if(case_result.moment_error_estimates,
                [&](const auto& own) { return own.solution == id; });
  std::erase_if(case_result.curves, [&](const auto& curve) { return curve.solution == id; });
}

// Requires that the simulations of a baseline are complete and have standard errors, since changes
// of simulations are measured in standard errors.
void require_complete_simulation(const Solution& solution) {
  const auto* interrupted = transform::find_metric(solution.metrics, kInterruptedMetric);
  if (interrupted != nullptr && interrupted->value == base::Value(true)) {
    throw InputError("the simulation was interrupted: run it again, to its end");
  }
  if (!solution.has_density()) return;
  for (const CheckedQuantity& quantity : solution_quantities(solution, {})) {
    if (quantity.kind != CheckedQuantityKind::simulated_error ||
        finite_number_or_nan(quantity.value) > 0)
      continue;
    throw InputError(fmt::format("{} = {} (must be a positive number: run again, and longer)",
                                 quantity.name, finite_number_or_nan(quantity.value)));
  }
}

// External densities of a baseline run have no method of computation. External densities are
// removed from the case, and a note states the removal.
BaselineCaseToRepeat plan_repetition(results::CaseResult& case_result,
                                     const methods::SolverRegistry& registry,
                                     const base::Values& option_overrides,
                                     std::vector<std::string>& notes) {
  BaselineCaseToRepeat again{case_result.problem, {}};
  std::vector<std::string> external_ids;
  for (const Solution& solution : case_result.solutions) {
    try {
      if (auto method = registry.method_for_solution(solution, option_overrides)) {
        if (solution.standard_errors) require_complete_simulation(solution);
        again.methods.push_back(std::move(*method));
      } else {
        external_ids.push_back(solution.id());
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}: {}", base::to_printable_text(case_result.name()),
                                   base::to_printable_text(solution.id()), error.what()));
    }
  }
  for (const auto& id : external_ids) {
    remove_solution(case_result, id);
    notes.push_back(
        fmt::format("{} {} is an external density: it is not solved again and not compared.",
                    case_result.name(), id));
  }
  case_result.update_assessment();
  return again;
}

}  // namespace

CheckBaseline load_baseline(const fs::path& path, const methods::SolverRegistry& registry,
                            const base::Values& option_overrides) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / results::kSummaryFile : path;
  const fs::path curves = file.parent_path() / results::kMarginalsFile;
  CheckBaseline baseline{results::load_run_summary(file), fs::exists(curves, ignored), {}, {}};
  if (baseline.has_marginals) {
    results::load_marginal_curves(curves, baseline.run);
  } else {
    baseline.notes.push_back(
        fmt::format("{} is missing beside the baseline: marginal densities are not compared.",
                    results::kMarginalsFile));
  }
  try {
    for (results::CaseResult& case_result : baseline.run.cases) {
      baseline.cases.push_back(
          plan_repetition(case_result, registry, option_overrides, baseline.notes));
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", base::to_printable_text(file.string()), error.what()));
  }
  if (std::ranges::all_of(baseline.cases,
                          [](const auto& case_result) { return case_result.methods.empty(); })) {
    throw InputError(fmt::format("{} has no solution that can be solved again: use another run",
                                 base::to_printable_text(file.string())));
  }
  return baseline;
}

results::Run repeat_baseline_run(const CheckBaseline& baseline, const std::string& command,
                                 int threads, const methods::ProgressListener& listener) {
  std::size_t total = 0, before = 0;
  for (const auto& case_result : baseline.cases) total += case_result.methods.size();
  results::Run run{results::current_program(command), {}};
  for (const auto& [problem, methods] : baseline.cases) {
    auto cases = methods::run_cases({problem}, methods, threads, [&](methods::RunProgress at) {
      at.done += before;
      at.total = total;
      if (listener) listener(at);
    });
    run.cases.push_back(std::move(cases.front()));
    before += methods.size();
  }
  return run;
}

}  // namespace fpkcheck::check
