#include "methods/complete_run.hpp"

#include "methods/bounds.hpp"
#include "methods/own_errors.hpp"

namespace fpkcheck::methods {

std::vector<results::Case> complete_run(const std::vector<problem::Problem>& problems,
                                        const std::vector<Method>& methods,
                                        const CompleteRun& how) {
  const auto look = [&] {
    if (how.look) how.look();
  };
  // Shared by the methods that estimate their errors and by the moment error estimates of all
  // solutions, so that each backward equation is solved once.
  const auto residuals = residuals_of(problems);
  auto cases =
      run_cases(problems, methods, how.threads, how.progress, residuals, how.case_listener);
  look();
  if (!how.with_dual) return cases;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    add_bounds(cases[k], how.threads);
    look();
    add_own_errors(cases[k], residuals[k], how.threads);
    if (how.case_listener) how.case_listener(cases[k]);
    look();
  }
  return cases;
}

}  // namespace fpkcheck::methods
