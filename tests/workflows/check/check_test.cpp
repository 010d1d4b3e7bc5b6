#include "workflows/check/compare_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/input_error.hpp"
#include "solved_run.hpp"

namespace fpkcheck::check {
namespace {

using tests::moved_by;
using tests::observation;
using tests::paper_baseline;
using tests::scale;
using tests::solution;
using tests::solved_run;
using transform::SolverMetricKind;

TEST(Check, ARunAgreesWithItselfAndWithItsFiles) {
  for (const results::Run* baseline : {&paper_baseline(), &solved_run()}) {
    const auto same = compare_runs(*baseline, solved_run(), {});
    for (const auto& quantity_change : same.quantities_beyond_tolerance())
      ADD_FAILURE() << quantity_change.solution << quantity_change.name;
    EXPECT_TRUE(same.agrees_with_baseline());
    EXPECT_GT(same.changes.size(), 1400u);
    EXPECT_EQ(same.solutions, baseline->cases[0].solutions.size());
  }
}

TEST(Check, FindsEveryCoefficientThatMovesByAMillionth) {
  std::size_t tried = 0;
  for (const auto& one : solved_run().cases[0].solutions) {
    const auto runs = tests::alone(one.id());
    for (const auto& o : one.metrics) {
      if (o.kind != SolverMetricKind::coefficient) continue;
      for (const double relative : {1e-6, -1e-6}) {
        const auto moved = moved_by(tests::scaled(one.id(), o.path, relative), {}, runs);
        ASSERT_EQ(moved.size(), 1u) << one.id() << " " << o.path;
        EXPECT_EQ(moved[0].solution, one.id());
        EXPECT_EQ(moved[0].kind, CheckedQuantityKind::coefficient);
        EXPECT_NEAR(moved[0].change, 1e-6, 1e-11);
      }
      ++tried;
    }
  }
  EXPECT_GT(tried, 80u);
}

TEST(Check, FindsEveryMomentThatMovesByAMillionth) {
  for (const auto& one : solved_run().cases[0].solutions) {
    if (one.standard_errors) continue;
    const auto runs = tests::alone(one.id());
    const double deviation = std::sqrt(one.moments.v2);
    for (const auto& of : transform::kMoments) {
      const auto moved = moved_by(
          [&](results::Run& run) {
            double& moment = solution(run, one.id()).moments.*of.moment;
            // E[y'] = 0 up to errors of the method: change it by 1e-6 of the deviation.
            moment = of.moment == of.size ? moment * (1 + 1e-6) : moment + 1e-6 * deviation;
          },
          {}, runs);
      ASSERT_EQ(moved.size(), 1u) << one.id() << " " << of.symbol;
      EXPECT_EQ(moved[0].kind, CheckedQuantityKind::moment);
      EXPECT_EQ(moved[0].name, of.symbol);
    }
  }
}

TEST(Check, FindsEveryResultThatMovesByAMillionth) {
  std::size_t tried = 0;
  for (const auto& one : solved_run().cases[0].solutions) {
    const auto runs = tests::alone(one.id());
    for (const auto& o : one.metrics) {
      const auto value = transform::metric_number(one.metrics, o.path);
      if (o.kind != SolverMetricKind::result || !o.standard_error_path.empty() || !value) continue;
      const double step =
          std::max(std::abs(*value), o.min_scale) * (o.is_rounding_sensitive ? 3e-6 : 1e-6);
      const auto moved = moved_by(
          [&](results::Run& run) {
            observation(solution(run, one.id()), o.path).value = *value + step;
          },
          {}, runs);
      // A changed power names another coefficient: the old one is missing, the new one is added.
      const bool is_power = o.path.starts_with("coefficients");
      ASSERT_EQ(moved.size(), is_power ? 2u : 1u) << one.id() << " " << o.path;
      EXPECT_EQ(moved[0].kind,
                is_power ? CheckedQuantityKind::coefficient : CheckedQuantityKind::detail);
      if (!is_power) {
        EXPECT_EQ(moved[0].name, o.path);
      }
      ++tried;
    }
  }
  EXPECT_GT(tried, 300u);
}

TEST(Check, FindsEveryChangedWordAndFlag) {
  std::size_t tried = 0;
  for (const auto& one : solved_run().cases[0].solutions) {
    const auto runs = tests::alone(one.id());
    for (const auto& o : one.metrics) {
      if (o.kind == SolverMetricKind::work || transform::metric_number(one.metrics, o.path))
        continue;
      const auto moved = moved_by(
          [&](results::Run& run) {
            observation(solution(run, one.id()), o.path).value = "another";
          },
          {}, runs);
      ASSERT_EQ(moved.size(), 1u) << one.id() << " " << o.path;
      ++tried;
    }
  }
  EXPECT_GT(tried, 10u);
}

TEST(Check, FindsQuantitiesThatOneRunLacks) {
  using Solutions = std::vector<transform::Solution>;
  const auto erase = [](auto& list, int place) { list.erase(list.begin() + place); };
  const auto without_solution = moved_by([&](results::Run& run) {
    Solutions& solutions = run.cases[0].solutions;
    erase(solutions, 1);
  });
  EXPECT_EQ(without_solution.at(0).name, "solution");
  EXPECT_EQ(moved_by([&](results::Run& run) { erase(run.cases[0].pairs, 3); }).size(), 1u);
  EXPECT_EQ(moved_by([&](results::Run& run) { erase(run.cases[0].curves, 0); }).size(), 1u);
  EXPECT_EQ(moved_by([&](results::Run& run) { run.cases[0].budget.clear(); }).size(),
            paper_baseline().cases[0].budget.size());
  results::Run other = solved_run();
  other.cases[0].problem.name = "another";
  EXPECT_THROW(compare_runs(paper_baseline(), other, {}), InputError);
}

TEST(Check, ToleratesRounding) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> relative(-1e-12, 1e-12);
  const auto disturb = [&](auto&... numbers) { (scale(numbers, relative(random)), ...); };
  const auto disturb_moments = [&](transform::Moments& m) {
    disturb(m.y1, m.y2, m.y4, m.v1, m.v2, m.v4);
  };
  const auto moved = moved_by([&](results::Run& run) {
    results::CaseResult& one = run.cases[0];
    for (auto& s : one.solutions) {
      disturb_moments(s.moments);
      disturb(s.mass, s.min_density, s.energy_residual);
      if (s.error) disturb(s.error->y_l1, s.error->ydot_l1);
      if (s.error) disturb_moments(s.error->moments);
      if (s.standard_errors) disturb_moments(s.standard_errors->moments);
      for (auto& o : s.metrics) {
        if (std::holds_alternative<double>(o.value)) disturb(o);
      }
    }
    for (auto& [a, b, variable, d, standard_error] : one.pairs) {
      if (standard_error) disturb(*standard_error);
      disturb(d.l1, d.l2, d.sup, d.hellinger, d.kl);
      for (auto& decade : d.log10_tail) disturb(decade.mean_abs);
    }
    for (auto& row : one.budget) {
      disturb(row.total, row.total_tail);
      for (auto& part : row.parts) disturb(part.l1, part.tail);
    }
    for (auto& curve : one.curves) {
      for (double& density : curve.density) disturb(density);
    }
  });
  EXPECT_TRUE(moved.empty()) << moved.front().solution << " " << moved.front().name;
}

TEST(Check, IgnoresWorkOptionsAndTimes) {
  EXPECT_TRUE(moved_by([](results::Run& run) {
                for (auto& one : run.cases[0].solutions) {
                  one.seconds = 1e3;
                  one.reason = "in other words";
                  one.options = {};
                  for (auto& o : one.metrics) {
                    if (o.kind == SolverMetricKind::work) o.value = std::int64_t{7};
                  }
                }
                observation(solution(run, "epc-gaussian-n6"), "condition").value = {};
              }).empty());
}

TEST(Check, UsesTheGivenTolerance) {
  const auto shift = [](results::Run& run) { scale(solution(run, "fd-kf").moments.y4, 3e-7); };
  EXPECT_EQ(moved_by(shift).size(), 1u);
  EXPECT_EQ(moved_by(shift, {.deterministic = 1e-6}).size(), 0u);
}

TEST(Check, WithoutMarginalsCurvesAreNotCompared) {
  results::Run other = solved_run();
  other.cases[0].curves.clear();
  EXPECT_FALSE(compare_runs(paper_baseline(), other, {}).agrees_with_baseline());
  EXPECT_TRUE(compare_runs(paper_baseline(), other, {}, false).agrees_with_baseline());
}

TEST(Check, ReportsTheLargestAllowedChangeOfEachKind) {
  results::Run other = solved_run();
  scale(solution(other, "fd-kf").moments.y2, 3e-9);
  scale(solution(other, "fd-km4").moments.y2, 5e-9);
  scale(solution(other, "fd-white").moments.y2, 1e-6);
  const auto compared = compare_runs(paper_baseline(), other, {});
  for (const auto& summary : summarise_changes_by_kind(compared)) {
    if (summary.kind != CheckedQuantityKind::moment) continue;
    EXPECT_EQ(summary.moved, 1u);
    ASSERT_NE(summary.largest, nullptr);
    EXPECT_EQ(summary.largest->solution, "fd-km4");
    EXPECT_NEAR(summary.largest->change, 5e-9, 1e-12);
    return;
  }
  ADD_FAILURE() << "no moments";
}

}  // namespace
}  // namespace fpkcheck::check
