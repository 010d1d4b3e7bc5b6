#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>
#include <string>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"
#include "methods/run_cases.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"
#include "workflows/sweep/execution/solve_point.hpp"

namespace fpkcheck::sweep {
namespace {

struct KeyOfSteps {
  const char *key, *values;
  double step;
};

std::vector<std::size_t> all_of(const SweepPlan& plan) {
  std::vector<std::size_t> all(plan.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

TEST(PointQueue, AssignsEachPointOnceTheLongestFirst) {
  const SweepPlan plan = tests::plan_of({parse_sweep_axis("impulse.rate", "log:0.1:10:200", "x")});
  SweepPointQueue queue(plan, all_of(plan), {});
  const auto seconds = [&](std::size_t p) { return std::get<double>(plan.points[p][0]); };
  std::set<std::size_t> seen;
  std::vector<std::size_t> order;
  for (auto point = queue.take_next_sweep_point(); point; point = queue.take_next_sweep_point()) {
    EXPECT_TRUE(seen.insert(*point).second);
    order.push_back(*point);
    queue.record_sweep_point_solve_time(*point, seconds(*point));
  }
  EXPECT_EQ(seen.size(), 200);
  // After the initial sample the order is by time; the last points are short.
  for (std::size_t k = 30; k + 1 < order.size(); ++k) {
    EXPECT_GE(seconds(order[k]), 0.95 * seconds(order[k + 1]));
  }
  EXPECT_EQ(queue.point_queue_state().done, 200);
  EXPECT_NEAR(*queue.point_queue_state().remaining_seconds, 0, 1);
}

TEST(PointQueue, SkipsSolvedPoints) {
  const SweepPlan plan = tests::small_plan();
  SweepPointQueue queue(plan, {0, 2, 4}, {tests::result_of(plan, 2), tests::result_of(plan, 1)});
  std::set<std::size_t> seen;
  for (auto point = queue.take_next_sweep_point(); point; point = queue.take_next_sweep_point())
    seen.insert(*point);
  EXPECT_EQ(seen, (std::set<std::size_t>{0, 4}));
  EXPECT_EQ(queue.point_queue_state().done, 1);
  EXPECT_EQ(queue.point_queue_state().total, 3);
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(JournaledPointQueue, ReportsThePointsOfAResumedSweep) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  const auto file = directory.path() / "journal";
  {
    JournaledPointQueue fresh(plan, directory.path(), {}, {});
    EXPECT_EQ(fresh.sweep_resumption_text(), "");
    for (const std::size_t point : {4, 0})
      fresh.store_solved_point({tests::result_of(plan, point), {}});
  }
  {
    const JournaledPointQueue again(plan, directory.path(), {}, {});
    const std::string text = again.sweep_resumption_text();
    EXPECT_TRUE(says(text, "2 of 6 points kept, 4 to solve")) << text;
    EXPECT_FALSE(says(text, "damaged")) << text;
  }
  // A killed process leaves the last line incomplete.
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 9);
  const std::string text =
      JournaledPointQueue(plan, directory.path(), {}, {}).sweep_resumption_text();
  EXPECT_TRUE(says(text, "1 of 6 points kept, 5 to solve")) << text;
  EXPECT_TRUE(says(text, "1 damaged line")) << text;
}

// A shard counts its own points alone.
TEST(JournaledPointQueue, OfAShardCountsItsPoints) {
  const tests::TemporaryDirectory directory;
  const SweepPlan plan = tests::small_plan();
  SweepJournal(directory.path() / "journal.2-of-3", plan).append(tests::result_of(plan, 1));
  const std::string text =
      JournaledPointQueue(plan, directory.path(), {2, 3}, {}).sweep_resumption_text();
  EXPECT_TRUE(says(text, "journal.2-of-3: 1 of 2 points kept, 1 to solve")) << text;
}

using transform::Status;

// With residuals the result is that of `run`.
TEST(SolvePoint, AgreesWithARunWhereErrorsComeFromResiduals) {
  SweepPlan plan = tests::plan_of({parse_sweep_axis("system.restitution", "0.9,0.98", "x")});
  plan.closure_errors = ClosureErrorSource::residuals;
  plan.methods = methods::builtin_registry().methods_selected_by_list(
      "epc-gaussian-n4,fd-white,fd-kf", {{"stepper", "direct"}});
  const auto point = solve_sweep_point(plan, 1);
  const auto run = methods::run_cases({plan.problem_at_sweep_point(1)}, plan.methods, 1, {});
  EXPECT_EQ(point.result.reference, "fd-kf");
  EXPECT_TRUE(point.curves.empty());
  for (std::size_t m = 0; m < 3; ++m) {
    const auto& kept = point.result.methods[m];
    const auto& solution = run[0].solutions[m];
    EXPECT_EQ(kept.status, solution.status);
    EXPECT_EQ(kept.moments->y4, solution.moments.y4);
    EXPECT_EQ(kept.error->ydot, solution.error->ydot_l1);
    if (m == 2) continue;
    EXPECT_EQ(kept.l1->y, run[0].l1_distance(solution.id(), "fd-kf", transform::StateVariable::y));
    EXPECT_EQ(kept.l1->ydot,
              run[0].l1_distance(solution.id(), "fd-kf", transform::StateVariable::ydot));
  }
  ASSERT_FALSE(point.result.methods[0].budget.empty());
  EXPECT_EQ(point.result.methods[0].budget[0].l1.y, run[0].budget[0].parts[0].l1);
  EXPECT_FALSE(point.result.methods[2].l1);
}

TEST(SolvePoint, ErrorOfAClosureIsDistancePlusReferenceError) {
  SweepPlan plan = tests::plan_of({parse_sweep_axis("system.restitution", "0.9,0.98", "x")});
  // In case 1 the L1 distances of n = 2 are 0.0044 and 0.030, those of n = 6 0.0023 and 0.0047.
  plan.methods = methods::builtin_registry().methods_selected_by_list(
      "epc-gaussian-n2,epc-gaussian-n6,fd-kf", {{"stepper", "direct"}});
  const auto found = solve_sweep_point(plan, 1).result.methods;
  ASSERT_TRUE(found[0].l1 && found[1].l1 && found[2].error);
  EXPECT_EQ(found[0].status, Status::inaccurate);
  EXPECT_NE(found[0].reason.find("its L1 distance from fd-kf is 0.0044 in p(y) and 0.03 in p(y')"),
            std::string::npos)
      << found[0].reason;
  EXPECT_EQ(found[1].status, Status::ok);
  for (const std::size_t m : {0, 1}) {
    EXPECT_DOUBLE_EQ(found[m].error->y, found[m].l1->y + found[2].error->y);
    EXPECT_DOUBLE_EQ(found[m].error->ydot, found[m].l1->ydot + found[2].error->ydot);
  }
}

TEST(SolvePoint, ErrorOfAClosureComesFromResidualsWithoutAReference) {
  SweepPlan plan = tests::plan_of({parse_sweep_axis("system.restitution", "0.9,0.98", "x")});
  plan.methods = methods::builtin_registry().methods_selected_by_list("epc-gaussian-n2", {});
  const auto by_default = solve_sweep_point(plan, 1).result.methods[0];
  plan.closure_errors = ClosureErrorSource::residuals;
  const auto by_residuals = solve_sweep_point(plan, 1).result.methods[0];
  EXPECT_EQ(by_default.status, Status::inaccurate);
  EXPECT_EQ(by_default.reason, by_residuals.reason);
  EXPECT_EQ(by_default.error, by_residuals.error);
}

// By Simpson's rule the change of a moment over three points is h/3 (f'_0 + 4 f'_1 + f'_2), up to a
// term of the fifth order in h, which is below the errors of the moments here.
TEST(SolvePoint, SlopesAgreeWithTheDifferencesBetweenPoints) {
  const KeyOfSteps cases[] = {{"system.restitution", "0.8:0.84:3", 0.02},
                              {"impulse.rate", "1.9:2.1:3", 0.1}};
  for (const auto& [key, values, step] : cases) {
    SweepPlan plan = tests::plan_of({parse_sweep_axis(key, values, "test")},
                                    SweepPlanDesign::product, "fd-white,fd-kf");
    EXPECT_EQ(solve_sweep_point(plan, 0).result.methods[1].find_slopes(key), nullptr);
    plan.slopes = true;
    std::vector<std::vector<SweepMethodResult>> points;
    for (std::size_t point = 0; point < 3; ++point) {
      points.push_back(solve_sweep_point(plan, point).result.methods);
    }
    for (std::size_t method = 0; method < 2; ++method) {
      SCOPED_TRACE(plan.methods[method].id() + ' ' + key);
      for (const auto& point : points) ASSERT_NE(point[method].find_slopes(key), nullptr);
      const auto check = [&](double transform::Moments::*moment, double MomentSlopes::*slope,
                             double MomentSlopes::*error) {
        const auto weighted = [&](double MomentSlopes::*member) {
          const auto at = [&](std::size_t k) {
            return points[k][method].find_slopes(key)->*member;
          };
          return step / 3 * (at(0) + 4 * at(1) + at(2));
        };
        constexpr double kMomentErrors = 4e-6;  // twice the error estimate of a moment
        const double difference =
            (*points[2][method].moments).*moment - (*points[0][method].moments).*moment;
        EXPECT_NEAR(weighted(slope), difference, weighted(error) + kMomentErrors);
        EXPECT_LT(weighted(error), 0.02 * std::abs(difference) + kMomentErrors);
      };
      check(&transform::Moments::y2, &MomentSlopes::y2, &MomentSlopes::y2_error);
      check(&transform::Moments::v2, &MomentSlopes::v2, &MomentSlopes::v2_error);
    }
  }
}

// No variance remains for this mean: E[Y]^2 must be below intensity / rate = 0.1.
TEST(SolvePoint, InconsistentValuesAreAFailedResult) {
  const SweepPlan plan = tests::plan_of({parse_sweep_axis("impulse.mean", "0,0.5", "x")});
  const auto point = solve_sweep_point(plan, 1).result;
  ASSERT_EQ(point.methods.size(), 2);
  EXPECT_EQ(point.methods[0].status, Status::failed);
  EXPECT_NE(point.methods[0].reason.find("mean"), std::string::npos);
  EXPECT_EQ(point.reference, "");
}

TEST(SolvePoint, AMethodThatHasNoMemoryFailsAlone) {
  SweepPlan plan = tests::quick_plan({parse_sweep_axis("system.restitution", "0.9,0.98", "x")});
  methods::Method greedy = plan.methods[0];
  greedy.solve = [](const auto&, const auto&) -> transform::Solution { throw std::bad_alloc(); };
  plan.methods.insert(plan.methods.begin(), greedy);
  const auto point = solve_sweep_point(plan, 0).result;
  EXPECT_TRUE(point.methods[0].reason.starts_with("out of memory"));
  EXPECT_TRUE(point.methods[1].moments);
}

TEST(SolveLeft, StoresEveryPointAndItsMarginals) {
  const tests::TemporaryDirectory directory;
  SweepPlan plan = tests::quick_plan({parse_sweep_axis("system.restitution", "0.9:1:5", "x")});
  plan.marginals = true;
  std::size_t told = 0;
  {
    JournaledPointQueue progress(plan, directory.path(), {}, [&](const SweepPointQueue::State& at) {
      EXPECT_EQ(at.total, 5);
      told = at.done;
    });
    solve_remaining_sweep_points(plan, progress, 2);
    EXPECT_EQ(progress.solved_points().size(), 5);
  }
  EXPECT_EQ(told, 5);
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "marginals" / "000004.csv"));
  JournaledPointQueue again(plan, directory.path(), {}, {});
  EXPECT_FALSE(again.take_next_sweep_point());
  EXPECT_EQ(again.point_queue_state().done, 5);
}

}  // namespace
}  // namespace fpkcheck::sweep
