#include "methods/case_results.hpp"

#include "methods/guaranteed_bounds.hpp"
#include "methods/moment_error_estimates.hpp"

namespace fpkcheck::methods {

std::vector<results::CaseResult> compute_case_results(const std::vector<problem::Problem>& problems,
                                                      const std::vector<Method>& methods,
                                                      const CaseResultSettings& settings) {
  const auto poll = [&] {
    if (settings.poll) settings.poll();
  };
  // The methods and the moment error estimates of all solutions share these estimators, so that
  // each backward equation is solved once.
  const auto estimators = make_error_estimators(problems);
  auto cases = run_cases(problems, methods, settings.threads, settings.progress, estimators,
                         settings.case_listener);
  poll();
  if (!settings.with_backward) return cases;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    add_guaranteed_bounds(cases[k], settings.threads);
    poll();
    add_moment_error_estimates(cases[k], estimators[k], settings.threads);
    if (settings.case_listener) settings.case_listener(cases[k]);
    poll();
  }
  return cases;
}

}  // namespace fpkcheck::methods
