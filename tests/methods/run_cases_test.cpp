#include "methods/run_cases.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "base/input_error.hpp"
#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/registry.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::methods {
namespace {

// A solver whose reason is the name of its problem, and that counts simultaneous calls.
struct Probe {
  std::atomic<int> running = 0;
  std::atomic<int> most_at_once = 0;

  Method method(const std::string& id, bool uses_all_processors = false) {
    return {.identity = {.id = id, .method = "probe"},
            .uses_all_processors = uses_all_processors,
            .solve = [this, uses_all_processors](const problem::Problem& problem,
                                                 const SolverInputContext& context) {
              const int now = ++running;
              if (uses_all_processors && now > 1)
                throw std::logic_error("a parallel method is not alone");
              for (int seen = most_at_once;
                   now > seen && !most_at_once.compare_exchange_weak(seen, now);) {
              }
              std::this_thread::sleep_for(std::chrono::milliseconds(20));
              if (context.progress) context.progress(0.5, "");
              --running;
              transform::Solution solution;
              solution.reason = problem.name;
              return solution;
            }};
  }
};

std::vector<problem::Problem> two_problems() {
  auto a = tests::paper_case(1), b = tests::paper_case(2);
  a.name = "a";
  b.name = "b";
  return {a, b};
}

TEST(RunCases, FillsTheTableOfProblemsAndMethodsInOrder) {
  Probe probe;
  const std::vector<Method> methods{probe.method("one"), probe.method("two"),
                                    probe.method("three", true)};
  const auto cases = run_cases(two_problems(), methods, 2, {});
  ASSERT_EQ(cases.size(), 2u);
  for (const auto& one : cases) {
    ASSERT_EQ(one.solutions.size(), 3u);
    EXPECT_EQ(one.solutions[0].id(), "one");
    EXPECT_EQ(one.solutions[2].id(), "three");
    for (const auto& solution : one.solutions) EXPECT_EQ(solution.reason, one.name());
  }
  EXPECT_EQ(probe.most_at_once, 2);
}

// The methods "one" and "three" have identical equations for the problem "a" only.
TEST(RunCases, SolvesIdenticalEquationsOnce) {
  Probe probe;
  std::atomic<int> solved = 0;
  const auto method = [&](const std::string& id, double equation) {
    Method counting = probe.method(id);
    counting.options = {{"equation", equation}};
    counting.solve = [&solved, equation, solve = counting.solve](
                         const problem::Problem& problem, const SolverInputContext& context) {
      ++solved;
      transform::Solution solution = solve(problem, context);
      solution.seconds = equation;
      return solution;
    };
    counting.options_of_identical_equation =
        [equation](const problem::Problem& problem) -> std::optional<base::Values> {
      if (equation == 4) return std::nullopt;
      return base::Values{{"equation", problem.name == "a" && equation == 3 ? 1 : equation}};
    };
    return counting;
  };
  std::size_t last = 0;
  const auto cases = run_cases(two_problems(),
                               {method("one", 1), method("two", 2), method("three", 3),
                                method("four", 4), method("five", 4)},
                               2, [&](const RunProgress& at) { last = std::max(last, at.done); });
  EXPECT_EQ(solved, 9);
  EXPECT_EQ(last, 10u);
  ASSERT_EQ(cases.size(), 2u);
  for (const auto& one : cases) {
    const bool is_shared = one.name() == "a";
    for (const auto& solution : one.solutions) EXPECT_EQ(solution.reason, one.name());
    const transform::Solution& third = one.solutions[2];
    EXPECT_EQ(third.id(), "three");
    EXPECT_EQ(third.options, (base::Values{{"equation", 3.0}}));
    // The solution of the method "one", which states its time, serves for the method "three".
    EXPECT_EQ(third.seconds, is_shared ? 1 : 3);
    EXPECT_EQ(one.solutions[0].seconds, 1);
  }
}

TEST(RunCases, SolvesTheFokkerPlanckEquationOfNoiseOnce) {
  const auto problem = tests::with_noise(
      problem::System({.damping = 0.5, .stiffness = 1}, problem::WallParameters{.none = true}),
      0.4);
  const auto methods = builtin_registry().methods_selected_by_list("fd-white,fd-km4,fd-kf", {});
  const auto solutions = run_cases({problem}, methods, 1, {}).front().solutions;
  ASSERT_EQ(solutions.size(), 3u);
  EXPECT_GT(solutions[0].seconds, 0);
  for (const auto& solution : solutions) {
    EXPECT_TRUE(solution.has_status_ok()) << solution.reason;
    EXPECT_EQ(solution.moments.v4, solutions[0].moments.v4);
    EXPECT_EQ(solution.seconds, solutions[0].seconds);
  }
}

TEST(RunCases, ReportsProgressOfEverySolution) {
  Probe probe;
  std::size_t finished = 0;
  RunProgress last{};
  run_cases(two_problems(), {probe.method("one"), probe.method("two", true)}, 2,
            [&](const RunProgress& at) {
              finished += at.fraction == 1;
              last = at;
            });
  EXPECT_EQ(finished, 4u);
  EXPECT_EQ(last.done, 4u);
  EXPECT_EQ(last.total, 4u);
  EXPECT_EQ(last.method, "two");
}

TEST(RunCases, ChecksAllMethodsBeforeSolving) {
  Probe probe;
  auto choosy = probe.method("two", true);
  choosy.check = [](const problem::Problem& problem) {
    if (problem.name == "b") throw InputError("not with b");
  };
  std::size_t begun = 0;
  EXPECT_THROW(
      run_cases(two_problems(), {probe.method("one"), choosy}, 2, [&](auto&&) { ++begun; }),
      InputError);
  EXPECT_EQ(begun, 0u);
  EXPECT_EQ(run_cases({two_problems().front()}, {choosy}, 2, {}).size(), 1u);
}

TEST(RunCases, ChecksTheTimeOfTheSimulation) {
  const auto simulation = builtin_registry().methods_selected_by_list("mcs", {{"time", 1e300}});
  EXPECT_THROW(require_compatible_options(two_problems(), simulation), InputError);
  EXPECT_NO_THROW(require_compatible_options(
      two_problems(), builtin_registry().methods_selected_by_list("epc,fd,mcs", {})));
}

TEST(RunCases, ContinuesIfOneMethodRunsOutOfMemory) {
  Probe probe;
  const auto without = [](const std::string& id, auto failure) {
    return Method{
        .identity = {.id = id, .method = "probe"},
        .solve = [=](const problem::Problem&, const SolverInputContext&) -> transform::Solution {
          throw failure;
        }};
  };
  const auto cases = run_cases(
      two_problems(),
      {without("memory", std::bad_alloc()), probe.method("one"),
       without("threads",
               std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)))},
      2, {});
  ASSERT_EQ(cases.size(), 2u);
  for (const auto& one : cases) {
    EXPECT_EQ(one.solutions[1].reason, one.name());
    for (const auto* id : {"memory", "threads"}) {
      const auto* failed = one.find(id);
      ASSERT_NE(failed, nullptr);
      EXPECT_EQ(failed->status, transform::Status::failed);
      EXPECT_TRUE(failed->reason.starts_with("out of memory")) << failed->reason;
    }
  }
  // Only a lack of memory is attributed to one method. Other system errors propagate.
  EXPECT_THROW(
      run_cases(two_problems(),
                {without("disk", std::system_error(std::make_error_code(std::errc::io_error)))}, 2,
                {}),
      std::system_error);
}

TEST(RunCases, PropagatesExceptionsOfSolvers) {
  const Method broken{
      .identity = {.id = "broken", .method = "probe"},
      .solve = [](const problem::Problem&, const SolverInputContext&) -> transform::Solution {
        throw std::runtime_error("no memory");
      }};
  EXPECT_THROW(run_cases(two_problems(), {broken}, 2, {}), std::runtime_error);
}

}  // namespace
}  // namespace fpkcheck::methods
