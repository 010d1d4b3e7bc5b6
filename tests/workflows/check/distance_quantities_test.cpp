#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solved_run.hpp"
#include "workflows/check/case_quantities.hpp"

namespace fpkcheck::check {
namespace {

using compare::DensityDistances;
using tests::kinds;
using tests::moved_by;
using tests::solution;
using Kinds = std::vector<CheckedQuantityKind>;

TEST(DistanceClaims, EveryDistanceOfAPairIsFound) {
  for (double DensityDistances::*distance :
       {&DensityDistances::l1, &DensityDistances::l2, &DensityDistances::sup,
        &DensityDistances::hellinger, &DensityDistances::kl}) {
    EXPECT_EQ(kinds(moved_by(
                  [&](results::Run& run) { run.cases[0].pairs[0].distances.*distance += 1e-7; })),
              Kinds{CheckedQuantityKind::distance});
  }
  EXPECT_EQ(kinds(moved_by([](results::Run& run) {
              run.cases[0].pairs[0].distances.log10_tail[2].mean_abs += 3e-6;
            })),
            Kinds{CheckedQuantityKind::tail});
}

TEST(DistanceClaims, ATailThatIsNotThereAndOtherBinsAreFound) {
  EXPECT_GT(moved_by([](results::Run& run) {
              for (auto& pair : run.cases[0].pairs) pair.distances.log10_tail.clear();
            }).size(),
            50u);
  const auto other_bins =
      moved_by([](results::Run& run) { ++run.cases[0].pairs[0].distances.log10_tail[1].bins; });
  ASSERT_EQ(other_bins.size(), 1u);
  EXPECT_TRUE(other_bins[0].name.starts_with("tail p(y) to"));
}

TEST(DistanceClaims, APairInTheOtherOrderIsAnother) {
  const auto found = moved_by([](results::Run& run) {
    auto& pair = run.cases[0].pairs[0];
    std::swap(pair.a, pair.b);
  });
  EXPECT_EQ(found.size(), 2u);
}

TEST(DistanceClaims, IgnoresADivergenceThatIsInfiniteInOneRun) {
  EXPECT_TRUE(moved_by([](results::Run& run) {
                run.cases[0].pairs[0].distances.kl = std::numeric_limits<double>::infinity();
              }).empty());
}

TEST(DistanceClaims, DistancesToASimulationMoveWithItsSamplingError) {
  const auto by = [](double l1) {
    return moved_by([&](results::Run& run) {
      for (auto& [a, b, variable, distances, error] : run.cases[0].pairs) {
        if (b != "mcs" || variable != transform::StateVariable::y || a != "fd-kf") continue;
        distances.l1 += l1;
        distances.kl += l1;  // not compared with a simulation
      }
    });
  };
  results::Run run = tests::paper_baseline();
  const auto& sampling = *solution(run, "mcs").sampling;
  const double expected = std::sqrt(2.0) * *sampling.y,
               quantile_99 = std::sqrt(2.0) * *sampling.y_99;
  const double allowed = expected + 4 * (quantile_99 - expected) / 2.326;
  EXPECT_GT(allowed, quantile_99);
  EXPECT_EQ(by(0.98 * allowed).size(), 0u);
  EXPECT_EQ(kinds(by(1.02 * allowed)), Kinds{CheckedQuantityKind::simulated_l1});
}

using compare::ErrorBudgetRow;
using tests::moved_by;
using tests::scale;
using tests::solution;

/// The changes that follow from a change of the first row of the budget.
std::vector<CheckedQuantityChange> moved_by_row(
    const std::function<void(ErrorBudgetRow&)>& change) {
  return moved_by([&](results::Run& run) { change(run.cases[0].budget[0]); });
}

TEST(BudgetClaims, FindsAnotherBudget) {
  using Number = double& (*)(ErrorBudgetRow&);
  // Relative changes, so that small entries (3e-5) are found too.
  for (const Number number :
       {Number([](ErrorBudgetRow& row) -> double& { return row.total; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.total_tail; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.tail_from; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.tail_to; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[0].l1; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[0].tail; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[0].uncertainty; }),
        Number([](ErrorBudgetRow& row) -> double& { return row.parts[4].l1; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[4].expected; }),
        Number([](ErrorBudgetRow& row) -> double& { return *row.parts[4].quantile_99; })}) {
    EXPECT_EQ(moved_by_row([&](ErrorBudgetRow& row) { scale(number(row), 0.01); }).size(), 1u);
  }
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) { ++row.tail_bins; }).size(), 1u);
}

TEST(BudgetClaims, ReportsAnotherChainOnce) {
  EXPECT_EQ(
      moved_by_row([](ErrorBudgetRow& row) { row.parts.erase(row.parts.begin() + 1); }).size(), 1u);
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) {
              row.parts[1].approximations = {compare::ModelApproximation::white_noise};
            }).size(),
            1u);
  EXPECT_EQ(moved_by_row([](ErrorBudgetRow& row) { row.reference = "fd-kf"; }).size(), 1u);
}

TEST(BudgetClaims, ReportsARowThatOneRunLacks) {
  const auto found = moved_by([](results::Run& run) { run.cases[0].budget.pop_back(); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, CheckedQuantityKind::budget);
  EXPECT_EQ(found[0].now, base::Value("missing"));
}

TEST(BudgetClaims, ABudgetToAnotherSimulationIsJudgedByItsSampling) {
  const auto by = [](const std::function<double&(ErrorBudgetRow&)>& number, double relative) {
    return moved_by([&](results::Run& run) {
             scale(solution(run, "mcs").moments.y2, 1e-6);  // another simulation
             scale(number(run.cases[0].budget[0]), relative);
           })
        .size();
  };
  const auto l1 = [](int part) {
    return [part](ErrorBudgetRow& row) -> double& { return row.parts[part].l1; };
  };
  const auto expected = [](ErrorBudgetRow& row) -> double& { return *row.parts[4].expected; };
  const auto tail = [](ErrorBudgetRow& row) -> double& { return row.parts[0].tail; };
  EXPECT_EQ(by(l1(4), 0.5), 0u);
  EXPECT_EQ(by(l1(4), 5), 1u);
  EXPECT_EQ(by(expected, 0.05), 0u);
  EXPECT_EQ(by(expected, 3), 1u);
  EXPECT_EQ(by(tail, 1), 0u);
  EXPECT_EQ(by(tail, 9), 1u);
  EXPECT_EQ(by(l1(0), 1e-5), 1u);  // deterministic
}

using results::DensityCurve;
using tests::moved_by;

DensityCurve& simulated_curve(results::Run& run) {
  return *std::ranges::find(run.cases[0].curves, "mcs", &DensityCurve::solution);
}

TEST(MarginalFigures, FindsEveryBinOfACurve) {
  const auto& curve = tests::paper_baseline().cases[0].curves.front();
  const double peak = std::ranges::max(curve.density);
  const auto runs = tests::alone(curve.solution);
  for (std::size_t k = 0; k < curve.density.size(); ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const auto moved = moved_by(
          [&](results::Run& run) { run.cases[0].curves.front().density[k] += sign * 1e-7 * peak; },
          {}, runs);
      ASSERT_EQ(moved.size(), 1u) << k;
      EXPECT_EQ(moved[0].kind, CheckedQuantityKind::marginal);
      EXPECT_NEAR(moved[0].change, 1e-7, 1e-13);
      EXPECT_NE(moved[0].name.find(fmt::format("{:.4g}", curve.abscissa[k])), std::string::npos);
    }
  }
}

TEST(MarginalFigures, CurvesOnOtherBinsCannotBeCompared) {
  const auto moved = moved_by([](results::Run& run) {
    for (double& x : run.cases[0].curves.front().abscissa) x *= 1.001;
  });
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_TRUE(std::isinf(moved[0].change));
}

TEST(MarginalFigures, SimulatedBinsHaveToleranceByIntervalAndNumberOfBins) {
  const auto by = [](double errors) {
    return moved_by([&](results::Run& run) {
      DensityCurve& curve = simulated_curve(run);
      const double error = (curve.upper[20] - curve.density[20]) / 1.96;
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) {
        (*values)[20] += errors * std::sqrt(2.0) * error;
      }
    });
  };
  EXPECT_EQ(by(4.5).size(), 0u);  // within the threshold for the largest of all bins
  ASSERT_EQ(by(5.2).size(), 1u);
  EXPECT_EQ(by(5.2)[0].kind, CheckedQuantityKind::simulated_bin);
  EXPECT_GT(by(5.2)[0].allowed, 4.7);
  EXPECT_LT(by(5.2)[0].allowed, 5.1);
}

TEST(MarginalFigures, FindsAnotherShapeOfASimulationByL1) {
  const auto moved = moved_by([](results::Run& run) {
    DensityCurve& curve = simulated_curve(run);  // too low near the wall, too high far from it
    for (std::size_t k = 0; k < curve.density.size(); ++k) {
      const double tilt = 0.05 * (curve.abscissa[k] - 0.5);
      for (auto* values : {&curve.density, &curve.lower, &curve.upper}) (*values)[k] *= 1 + tilt;
    }
  });
  EXPECT_TRUE(std::ranges::any_of(moved, [](const CheckedQuantityChange& quantity_change) {
    return quantity_change.kind == CheckedQuantityKind::simulated_l1;
  }));
}

}  // namespace
}  // namespace fpkcheck::check
