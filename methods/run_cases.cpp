#include "methods/run_cases.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>

#include "methods/side_by_side.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;

struct Task {
  std::size_t problem;
  std::size_t method;
};

// The cells of the table problems x methods as they get filled.
class Run {
 public:
  Run(const std::vector<problem::Problem>& problems, const std::vector<Method>& methods,
      const ProgressListener& listener, const std::vector<ProblemResiduals>& residuals)
      : problems_(problems), methods_(methods), listener_(listener), residuals_(residuals) {
    for (const auto& problem : problems) axes_.push_back(compare::comparison_axes(problem));
    solutions_.assign(problems.size(), std::vector<std::optional<Solution>>(methods.size()));
  }

  void solve(const Task& task) {
    const Method& method = methods_[task.method];
    tell(task, 0, "");
    const Fraction progress = [this, &task](double fraction, const std::string& note) {
      tell(task, std::min(fraction, 0.999), note);
    };
    solutions_[task.problem][task.method] =
        solve_by(method, problems_[task.problem],
                 {axes_[task.problem], progress, &residuals_[task.problem]});
    ++done_;
    tell(task, 1, "");
  }

  std::vector<results::Case> cases() {
    std::vector<results::Case> cases;
    for (std::size_t p = 0; p < problems_.size(); ++p) {
      std::vector<Solution> solutions;
      for (auto& solution : solutions_[p]) solutions.push_back(std::move(*solution));
      cases.push_back(results::make_case(problems_[p], axes_[p], std::move(solutions)));
    }
    return cases;
  }

 private:
  void tell(const Task& task, double fraction, const std::string& note) {
    if (!listener_) return;
    const std::lock_guard lock(listener_mutex_);
    listener_({.done = done_,
               .total = problems_.size() * methods_.size(),
               .case_name = problems_[task.problem].name,
               .method = methods_[task.method].id(),
               .fraction = fraction,
               .note = note});
  }

  const std::vector<problem::Problem>& problems_;
  const std::vector<Method>& methods_;
  const ProgressListener& listener_;
  const std::vector<ProblemResiduals>& residuals_;
  std::vector<compare::ComparisonAxes> axes_;
  std::vector<std::vector<std::optional<Solution>>> solutions_;
  std::atomic<std::size_t> done_ = 0;
  std::mutex listener_mutex_;
};

}  // namespace

Solution solve_by(const Method& method, const problem::Problem& problem, const Setting& setting) {
  Solution solution = method.solve(problem, setting);
  solution.identity = method.identity;
  solution.options = method.options;
  return solution;
}

std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener) {
  return run_cases(problems, methods, threads, listener, residuals_of(problems));
}

std::vector<results::Case> run_cases(const std::vector<problem::Problem>& problems,
                                     const std::vector<Method>& methods, int threads,
                                     const ProgressListener& listener,
                                     const std::vector<ProblemResiduals>& residuals) {
  Run run(problems, methods, listener, residuals);
  std::vector<Task> several;
  std::vector<Task> alone;
  for (std::size_t p = 0; p < problems.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      (methods[m].parallel ? alone : several).push_back({p, m});
    }
  }
  side_by_side(several.size(), threads, [&](std::size_t t) { run.solve(several[t]); });
  for (const Task& task : alone) run.solve(task);
  return run.cases();
}

}  // namespace fpkcheck::methods
