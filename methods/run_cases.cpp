#include "methods/run_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <variant>
#include <vector>

#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "compare/solution_assessment.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;

struct MethodSolveTask {
  std::size_t problem;
  std::size_t method;
};

// Collects the solutions of a run, shape (problems, methods), and reports the progress.
class SolutionsByProblemAndMethod {
 public:
  SolutionsByProblemAndMethod(const std::vector<problem::Problem>& problems,
                              const std::vector<Method>& methods, const ProgressListener& listener,
                              const std::vector<ResidualErrorEstimator>& estimators,
                              const CaseListener& case_listener)
      : problems_(problems),
        methods_(methods),
        listener_(listener),
        estimators_(estimators),
        case_listener_(case_listener),
        unsolved_(problems.size()),
        cases_(problems.size()) {
    for (const auto& problem : problems) axes_.push_back(compare::comparison_bins(problem));
    solutions_.assign(problems.size(), std::vector<std::optional<Solution>>(methods.size()));
    for (auto& missing : unsolved_) missing = methods.size();
    for (const auto& problem : problems) solved_by_.push_back(solving_methods(problem));
  }

  // Returns whether the method solves the problem itself; false if the solution of another method
  // is the same.
  bool is_solved_by_itself(const MethodSolveTask& task) const {
    return solved_by_[task.problem][task.method] == task.method;
  }

  void solve(const MethodSolveTask& task) {
    if (case_listener_ && base::stop_requested()) return;
    const Method& method = methods_[task.method];
    report_progress(task, 0, "");
    ProgressCallback progress;
    if (listener_) {
      progress = [this, &task](double fraction, const std::string& note) {
        report_progress(task, std::min(fraction, 0.999), note);
      };
    }
    const Solution solution =
        solve_with_method(method, problems_[task.problem],
                          {axes_[task.problem], progress, &estimators_[task.problem],
                           estimators_[task.problem].unsupported_reason().empty()});
    std::size_t solved = 0;
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      if (solved_by_[task.problem][m] != task.method) continue;
      Solution& copy = solutions_[task.problem][m].emplace(solution);
      ++solved;
      if (m == task.method) continue;
      copy.identity = methods_[m].identity;
      copy.options = methods_[m].options;
    }
    done_ += solved;
    if ((unsolved_[task.problem] -= solved) == 0) assemble_case_result(task.problem);
    report_progress(task, 1, "");
  }

  std::vector<results::CaseResult> cases() {
    std::vector<results::CaseResult> cases;
    for (auto& one : cases_) {
      if (one) cases.push_back(std::move(*one));
    }
    return cases;
  }

 private:
  // Returns, for each method, the index of the method whose solution the method copies: the first
  // method of the same solver with an identical equation, or the method itself.
  std::vector<std::size_t> solving_methods(const problem::Problem& problem) const {
    std::vector<std::optional<base::Values>> equations;
    std::vector<std::size_t> solving;
    for (std::size_t m = 0; m < methods_.size(); ++m) {
      const Method& method = methods_[m];
      equations.push_back(method.options_of_identical_equation
                              ? method.options_of_identical_equation(problem)
                              : std::nullopt);
      const auto is_same = [&](std::size_t other) {
        return equations[m] && methods_[other].identity.method == method.identity.method &&
               equations[other] == equations[m];
      };
      std::size_t first = 0;
      while (first < m && !is_same(first)) ++first;
      solving.push_back(first);
    }
    return solving;
  }

  void assemble_case_result(std::size_t p) {
    std::vector<Solution> solutions;
    for (auto& solution : solutions_[p]) solutions.push_back(std::move(*solution));
    complete_error_estimates(methods_, axes_[p], estimators_[p], solutions);
    cases_[p] = results::make_case_result(problems_[p], axes_[p], std::move(solutions));
    if (case_listener_) case_listener_(*cases_[p]);
  }

  void report_progress(const MethodSolveTask& task, double fraction, const std::string& note) {
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
  const std::vector<ResidualErrorEstimator>& estimators_;
  const CaseListener& case_listener_;
  std::vector<compare::ComparisonBins> axes_;
  std::vector<std::vector<std::optional<Solution>>> solutions_;
  // Index of the method whose solution serves for a method, shape (problems, methods)
  std::vector<std::vector<std::size_t>> solved_by_;
  std::vector<std::atomic<std::size_t>> unsolved_;  // number of missing solutions of each case
  std::vector<std::optional<results::CaseResult>> cases_;
  std::atomic<std::size_t> done_ = 0;
  std::mutex listener_mutex_;
};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// L1 distances of a solution from the reference; empty if the solution or the reference lacks the
// marginal density.
struct L1DistancesFromReference {
  std::optional<double> y, ydot;

  explicit operator bool() const { return y || ydot; }
};

void set_error_from_reference_distance(const Solution& reference,
                                       const L1DistancesFromReference& distance,
                                       Solution& solution) {
  const auto with_reference_error = [&](const std::optional<double>& l1, StateVariable variable) {
    return l1 ? *l1 + compare::l1_error_estimate(reference, variable) : kUnknown;
  };
  transform::ErrorEstimate error{
      .y_l1 = with_reference_error(distance.y, StateVariable::y),
      .ydot_l1 = with_reference_error(distance.ydot, StateVariable::ydot)};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    error.moments.*moment = std::abs(solution.moments.*moment - reference.moments.*moment);
    if (reference.error) error.moments.*moment += reference.error->moments.*moment;
  }
  solution.error = error;
}

}  // namespace

Solution solve_with_method(const Method& method, const problem::Problem& problem,
                           const SolverInputContext& context) {
  Solution solution;
  if (!run_unless_out_of_memory([&] { solution = method.solve(problem, context); })) {
    solution.status = transform::Status::failed;
    solution.reason = kOutOfMemory;
  }
  solution.identity = method.identity;
  solution.options = method.options;
  // Error estimates of closures and external densities may be set later, from the distance to the
  // reference (complete_error_estimates).
  const auto role = method.identity.role;
  if (role == transform::SolutionRole::equation || role == transform::SolutionRole::simulation) {
    transform::require_error_estimate(solution);
  }
  return solution;
}

void require_compatible_options(const std::vector<problem::Problem>& problems,
                                const std::vector<Method>& methods) {
  const auto references = std::ranges::count_if(methods, [](const Method& method) {
    return method.identity.role == transform::SolutionRole::measurement;
  });
  if (references > 1) {
    throw InputError(
        fmt::format("{} densities have the role of reference; choose one", references));
  }
  for (const auto& method : methods) {
    if (!method.check) continue;
    for (const auto& problem : problems) method.check(problem);
  }
}

std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener) {
  return run_cases(problems, methods, thread_count, listener, make_error_estimators(problems), {});
}

std::vector<results::CaseResult> run_cases(const std::vector<problem::Problem>& problems,
                                           const std::vector<Method>& methods, int thread_count,
                                           const ProgressListener& listener,
                                           const std::vector<ResidualErrorEstimator>& estimators,
                                           const CaseListener& case_listener) {
  require_compatible_options(problems, methods);
  SolutionsByProblemAndMethod run(problems, methods, listener, estimators, case_listener);
  // The first closure of a problem computes the residual-based error estimator, and the other
  // closures of the problem wait for the estimator. While the first closure computes the
  // residual-based error estimator, other processors compute solutions without the estimator.
  const auto is_closure = [&](std::size_t m) {
    return methods[m].identity.role == transform::SolutionRole::closure;
  };
  std::vector<std::size_t> order(methods.size());
  std::iota(order.begin(), order.end(), 0);
  const auto first_closure =
      std::stable_partition(order.begin(), order.end(), std::not_fn(is_closure));
  if (first_closure != order.end()) std::rotate(order.begin(), first_closure, first_closure + 1);
  // Problems are completed in blocks, one block after another, so that after a stop request only
  // the problems of one block are incomplete.
  const auto block = static_cast<std::size_t>(base::resolve_thread_count(thread_count));
  std::vector<MethodSolveTask> single_threaded;
  for (std::size_t begin = 0; begin < problems.size(); begin += block) {
    const std::size_t end = std::min(begin + block, problems.size());
    for (const std::size_t m : order) {
      if (methods[m].uses_all_processors) continue;
      for (std::size_t p = begin; p < end; ++p) {
        if (run.is_solved_by_itself({p, m})) single_threaded.push_back({p, m});
      }
    }
  }
  base::parallel_for(single_threaded.size(), thread_count,
                     [&](std::size_t t) { run.solve(single_threaded[t]); });
  for (std::size_t p = 0; p < problems.size(); ++p) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (methods[m].uses_all_processors && run.is_solved_by_itself({p, m})) run.solve({p, m});
    }
  }
  return run.cases();
}

std::optional<double> required_accuracy(const Method& method) {
  if (method.identity.role != transform::SolutionRole::closure) return std::nullopt;
  for (const auto& [name, value] : method.options) {
    if (name != "accuracy") continue;
    if (const auto* number = std::get_if<double>(&value)) return *number;
  }
  return std::nullopt;
}

void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonBins& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<Solution>& solutions,
                              const compare::SolutionComparison* comparison) {
  const compare::SolutionsAssessment assessment = compare::assess_solutions(solutions);
  // The distance from a density that the user chose as the reference is no error estimate: the
  // density may be a measurement of another system.
  const Solution* const reference = assessment.is_reference_chosen_by_user
                                        ? nullptr
                                        : transform::find_solution(solutions, assessment.reference);
  std::optional<compare::SolutionComparison> computed_comparison;
  const auto distance = [&](const Solution& solution) -> L1DistancesFromReference {
    if (reference == nullptr) return {};
    if (comparison == nullptr)
      comparison = &computed_comparison.emplace(compare::compare_solutions(axes, solutions));
    const auto l1 = [&](StateVariable variable) {
      return compare::l1_distance_between(comparison->pairs, solution.id(), reference->id(),
                                          variable);
    };
    return {l1(StateVariable::y), l1(StateVariable::ydot)};
  };
  for (std::size_t m = 0; m < solutions.size(); ++m) {
    Solution& solution = solutions[m];
    const auto accuracy = solution.error ? std::nullopt : required_accuracy(methods[m]);
    if (accuracy && solution.density) {
      if (const L1DistancesFromReference found = distance(solution); found.y && found.ydot) {
        // If the status is `inaccurate` here, the only reason is the missing error estimate.
        if (solution.status == transform::Status::inaccurate) {
          solution.status = transform::Status::ok;
          solution.reason.clear();
        }
        set_error_from_reference_distance(*reference, found, solution);
        transform::require_accuracy(
            *accuracy,
            fmt::format(
                "the closure meets its equations, but its L1 distance from {} is {:.2g} in p(y) "
                "and {:.2g} in p(y')",
                reference->id(), *found.y, *found.ydot),
            solution);
      } else if (solution.has_status_ok()) {
        set_residual_error_estimate(estimator, *accuracy, solution);
      }
    } else if (solution.has_status_ok() && &solution != reference &&
               !transform::has_error_estimate(solution)) {
      if (const L1DistancesFromReference found = distance(solution)) {
        set_error_from_reference_distance(*reference, found, solution);
      } else if (methods[m].identity.role == transform::SolutionRole::closure) {
        set_residual_error_estimate(estimator, HUGE_VAL, solution);
      }
    }
    if (solution.identity.role != transform::SolutionRole::measurement)
      transform::require_error_estimate(solution);
  }
}

}  // namespace fpkcheck::methods
