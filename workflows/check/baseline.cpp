#include "workflows/check/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "base/text/shown.hpp"
#include "results/saved_run.hpp"
#include "workflows/check/chance.hpp"
#include "workflows/check/claims.hpp"

namespace fpkcheck::check {
namespace {

namespace fs = std::filesystem;
using transform::Solution;

// Removes a solution that no method of this program made, with its distances, error budget and
// curves: it cannot be solved again.
void leave_out(results::Case& one, const std::string& id) {
  std::erase_if(one.solutions, [&](const auto& solution) { return solution.id() == id; });
  std::erase_if(one.pairs, [&](const auto& pair) { return pair.a == id || pair.b == id; });
  std::erase_if(one.budget, [&](const auto& row) { return row.solution == id; });
  std::erase_if(one.own_errors, [&](const auto& own) { return own.solution == id; });
  std::erase_if(one.curves, [&](const auto& curve) { return curve.solution == id; });
}

// A simulation is compared by its own standard errors: without them, or interrupted, it cannot
// serve as a baseline.
void require_whole_simulation(const Solution& solution) {
  const auto* interrupted = transform::find(solution.observations, kInterrupted);
  if (interrupted != nullptr && interrupted->value == base::Value(true)) {
    throw InputError("the simulation was interrupted: run it again, to its end");
  }
  if (!solution.has_density()) return;
  for (const Claim& claim : solution_claims(solution, {})) {
    if (claim.kind != FigureKind::simulated_error || number_in(claim.value) > 0) continue;
    throw InputError(fmt::format("{} = {} (must be a positive number: run again, and longer)",
                                 claim.name, number_in(claim.value)));
  }
}

// The methods of a case. Solutions of external densities have none: they are removed, with a note.
CaseAgain plan(results::Case& one, const methods::Registry& registry, const base::Values& given,
               std::vector<std::string>& notes) {
  CaseAgain again{one.problem, {}};
  std::vector<std::string> not_ours;
  for (const Solution& solution : one.solutions) {
    try {
      if (auto method = registry.that_made(solution, given)) {
        if (solution.standard_errors) require_whole_simulation(solution);
        again.methods.push_back(std::move(*method));
      } else {
        not_ours.push_back(solution.id());
      }
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}: {}", base::shown(one.name()),
                                   base::shown(solution.id()), error.what()));
    }
  }
  for (const auto& id : not_ours) {
    leave_out(one, id);
    notes.push_back(fmt::format(
        "{} {} is an external density: it is not solved again and not compared.", one.name(), id));
  }
  return again;
}

}  // namespace

Baseline load_baseline(const fs::path& place, const methods::Registry& registry,
                       const base::Values& given) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(place, ignored) ? place / results::kSummaryFile : place;
  const fs::path curves = file.parent_path() / results::kMarginalsFile;
  Baseline baseline{results::load_summary(file), fs::exists(curves, ignored), {}, {}};
  if (baseline.has_marginals) {
    results::load_curves(curves, baseline.run);
  } else {
    baseline.notes.push_back(
        fmt::format("{} is missing beside the baseline: marginal densities are not compared.",
                    results::kMarginalsFile));
  }
  try {
    for (results::Case& one : baseline.run.cases) {
      baseline.cases.push_back(plan(one, registry, given, baseline.notes));
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", base::shown(file.string()), error.what()));
  }
  if (std::ranges::all_of(baseline.cases, [](const auto& one) { return one.methods.empty(); })) {
    throw InputError(fmt::format("{} has no solution that can be solved again: use another run",
                                 base::shown(file.string())));
  }
  return baseline;
}

results::Run run_again(const Baseline& baseline, const std::string& command, int threads,
                       const methods::ProgressListener& listener) {
  std::size_t total = 0, before = 0;
  for (const auto& one : baseline.cases) total += one.methods.size();
  results::Run run{results::this_program(command), {}};
  // Each case has its own list of methods.
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
