#include <gtest/gtest.h>

#include <cmath>

#include "solved_run.hpp"
#include "workflows/check/case_quantities.hpp"

namespace fpkcheck::check {
namespace {

using tests::case_of;
using tests::moved_by;
using tests::observation;
using tests::scale;
using tests::scaled;
using tests::solution;
using transform::Metrics;
using transform::SolverMetric;
using transform::SolverMetricKind;

/// The changes between two solutions that have these metrics alone.
std::vector<CheckedQuantityChange> moved(const Metrics& was, const Metrics& is) {
  return compare_runs({.program = {}, .cases = {case_of(was)}},
                      {.program = {}, .cases = {case_of(is)}}, {})
      .quantities_beyond_tolerance();
}

/// The changes of a single number with these properties.
std::vector<CheckedQuantityChange> moved(const SolverMetric& described, double was, double is) {
  SolverMetric now = described;
  now.value = is;
  // A baseline from files has the value alone.
  return moved({{.path = described.path, .value = was}}, {now});
}

TEST(MetricQuantities, ResultsChangeRelativeToTheLargerOfSizeAndLeastScale) {
  const SolverMetric plain{.path = "x", .value = {}};
  EXPECT_EQ(moved(plain, 1, 1 + 0.9e-8).size(), 0u);
  EXPECT_EQ(moved(plain, 1, 1 + 1.1e-8).size(), 1u);
  EXPECT_EQ(moved(plain, 100, 100 + 0.9e-6).size(), 0u);
  EXPECT_EQ(moved(plain, 1e-5, 1e-5 + 0.9e-9).size(), 0u);
  EXPECT_EQ(moved(plain, 1e-5, 1e-5 + 1.1e-9).size(), 1u);
  const SolverMetric faint{.path = "x", .value = {}, .min_scale = 1e-6};
  EXPECT_EQ(moved(faint, 1e-9, 1e-9 + 0.9e-14).size(), 0u);
  EXPECT_EQ(moved(faint, 1e-9, 1e-9 + 1.1e-14).size(), 1u);
  const SolverMetric is_rounding_sensitive{.path = "x", .value = {}, .is_rounding_sensitive = true};
  EXPECT_EQ(moved(is_rounding_sensitive, 1, 1 + 0.9e-6).size(), 0u);
  EXPECT_EQ(moved(is_rounding_sensitive, 1, 1 + 1.1e-6).size(), 1u);
}

TEST(MetricQuantities, CoefficientsAreNamedByPowersAndHaveLargerTolerance) {
  const auto list = [](double a) {
    return Metrics{{.path = "coefficients[0].x1", .value = std::int64_t{4}},
                   {.path = "coefficients[0].x2", .value = std::int64_t{2}},
                   {.path = "coefficients[0].a",
                    .value = a,
                    .kind = SolverMetricKind::coefficient,
                    .min_scale = 1e-3}};
  };
  EXPECT_EQ(moved(list(-0.01), list(-0.01 * (1 + 4e-7))).size(), 0u);
  const auto found = moved(list(-0.01), list(-0.01 * (1 + 6e-7)));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "a(4,2)");
  EXPECT_EQ(found[0].kind, CheckedQuantityKind::coefficient);
  EXPECT_EQ(moved(list(0), list(4e-10)).size(), 0u);
  EXPECT_EQ(moved(list(0), list(6e-10)).size(), 1u);
}

TEST(MetricQuantities, IgnoresRoundingOfAZeroCoefficient) {
  const auto by = [](double was, double is) {
    results::Run baseline = tests::solved_run(), now = baseline;
    observation(solution(baseline, "epc-gaussian-n6"), "coefficients[1].a").value = was;
    observation(solution(now, "epc-gaussian-n6"), "coefficients[1].a").value = is;
    return !compare_runs(baseline, now, {}).agrees_with_baseline();
  };
  EXPECT_FALSE(by(1e-16, -3e-16));
  EXPECT_FALSE(by(0, 2e-16));
  EXPECT_TRUE(by(0, 1e-9));
}

TEST(MetricQuantities, IgnoresWorkAndText) {
  for (const SolverMetricKind kind : {SolverMetricKind::work, SolverMetricKind::text}) {
    const SolverMetric o{.path = "x", .value = "new", .kind = kind};
    EXPECT_TRUE(moved({{.path = "x", .value = 3.0}}, {o}).empty());
    EXPECT_TRUE(moved({}, {o}).empty());
  }
  // The kind of an entry follows from other entries of its list, or from the list where it is
  // empty.
  const Metrics two{{.path = "seen[0].at", .value = 1.0}, {.path = "seen[1].at", .value = 2.0}};
  EXPECT_TRUE(
      moved(two, {{.path = "seen[0].at", .value = 7.0, .kind = SolverMetricKind::work}}).empty());
  EXPECT_TRUE(
      moved(two, {{.path = "seen[]", .value = {}, .kind = SolverMetricKind::work}}).empty());
  EXPECT_EQ(moved(two, {{.path = "seen[]", .value = {}}}).size(), 1u);
  const Metrics by_entry{{.path = "seen[0].at", .value = 1.0},
                         {.path = "seen[1].note", .value = 2.0, .kind = SolverMetricKind::work},
                         {.path = "seen[2].at", .value = 1.0}};
  EXPECT_TRUE(moved({{.path = "seen[0].at", .value = 1.0},
                     {.path = "seen[0].note", .value = 5.0},
                     {.path = "seen[1].note", .value = 5.0},
                     {.path = "seen[2].at", .value = 1.0}},
                    by_entry)
                  .empty());
}

TEST(MetricQuantities, WordsFlagsAndEmptyValuesMustBeEqual) {
  const auto by = [](const base::Value& was, const base::Value& is) {
    return moved({{.path = "x", .value = was}}, {{.path = "x", .value = is}}).size();
  };
  EXPECT_EQ(by("a", "a"), 0u);
  EXPECT_EQ(by("a", "b"), 1u);
  EXPECT_EQ(by(true, false), 1u);
  EXPECT_EQ(by({}, {}), 0u);
  EXPECT_EQ(by({}, 1.0), 1u);
  EXPECT_EQ(by(std::int64_t{40}, 40.0), 0u);
  EXPECT_EQ(by({}, NAN), 0u);  // files store NaN as an empty value
}

TEST(MetricQuantities, ReportsAMissingMetricOnce) {
  const Metrics whole{{.path = "a", .value = 1.0},
                      {.path = "part.b", .value = 1.0},
                      {.path = "part.c", .value = 2.0},
                      {.path = "list[0].d", .value = 1.0},
                      {.path = "list[1].d", .value = 2.0}};
  const auto without = [&](const std::string& start) {
    Metrics rest = whole;
    std::erase_if(rest, [&](const auto& o) { return o.path.starts_with(start); });
    return rest;
  };
  for (const char* start : {"a", "part", "list", "list[0]", "part.c", "list[1].d"}) {
    EXPECT_EQ(moved(whole, without(start)).size(), 1u) << start;
    EXPECT_EQ(moved(without(start), whole).size(), 1u) << start;
  }
  Metrics none = without("part");
  none.push_back({.path = "part", .value = {}});
  EXPECT_EQ(moved(whole, none).size(), 1u);
  EXPECT_EQ(moved(none, whole).size(), 1u);
}

TEST(MetricQuantities, ReportsNewResultsButNotNewErrorsWorkOrText) {
  const auto by = [](SolverMetricKind kind) {
    return moved({}, {{.path = "part.new", .value = 1.0, .kind = kind}}).size();
  };
  EXPECT_EQ(by(SolverMetricKind::result), 1u);
  EXPECT_EQ(by(SolverMetricKind::coefficient), 1u);
  EXPECT_EQ(by(SolverMetricKind::error), 0u);
  EXPECT_EQ(by(SolverMetricKind::work), 0u);
  EXPECT_EQ(by(SolverMetricKind::text), 0u);
}

/// A value and its standard error, as a solver states them.
Metrics estimate(double value, double error, bool is_rounding_sensitive = false) {
  return {{.path = "rate",
           .value = value,
           .standard_error_path = "rate_error",
           .is_rounding_sensitive = is_rounding_sensitive},
          {.path = "rate_error", .value = error, .kind = SolverMetricKind::error}};
}

TEST(MetricQuantities, EstimatesChangeInStandardErrorsOfBothRuns) {
  EXPECT_EQ(moved(estimate(1, 0.1), estimate(1.55, 0.1)).size(), 0u);
  const auto found = moved(estimate(1, 0.1), estimate(1.58, 0.1));  // above 4 sqrt(2) errors
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, CheckedQuantityKind::simulated);
  EXPECT_NEAR(found[0].change, 5.8 / std::sqrt(2.0), 1e-12);
  // A baseline without the standard error: that of the new run serves for both.
  EXPECT_EQ(moved({{.path = "rate", .value = 1.0}}, estimate(1.55, 0.1)).size(), 0u);
  EXPECT_EQ(moved({{.path = "rate", .value = 1.0}}, estimate(1.58, 0.1)).size(), 1u);
  // The standard error is compared too.
  EXPECT_EQ(moved(estimate(1, 0.1), estimate(1, 0.13)).size(), 0u);
  EXPECT_EQ(moved(estimate(1, 0.1), estimate(1, 0.2)).size(), 1u);
  EXPECT_EQ(moved(estimate(1, 0.1), estimate(1, NAN)).size(), 1u);
}

TEST(MetricQuantities, TheErrorOfADelicateValueIsNotJudged) {
  EXPECT_EQ(moved(estimate(1, 0.1, true), estimate(1, 0.9, true)).size(), 0u);
  EXPECT_EQ(moved(estimate(0, 0, true), estimate(3, 1, true)).size(), 0u);
  EXPECT_EQ(moved(estimate(0, 0, true), estimate(5, 1, true)).size(), 1u);
}

TEST(MetricQuantities, EffectiveSamplesHaveTheToleranceOfTheSquaredError) {
  const auto by = [](double was, double is) {
    const SolverMetric now{.path = "samples", .value = is, .kind = SolverMetricKind::error};
    return moved({{.path = "samples", .value = was}}, {now}).size();
  };
  EXPECT_EQ(by(1e5, 2.2e5), 0u);
  EXPECT_EQ(by(1e5, 4e5), 1u);
  for (const double bad : {0.0, -1.0, double(NAN)}) EXPECT_EQ(by(bad, 1e5), 1u);
}

TEST(MetricQuantities, FindsEstimatesThatChangeByMoreThanSampling) {
  for (const char* path : {"impact_rate", "joint_moments[5].mean", "quantiles.y[4].value",
                           "quantiles.ydot[9].value", "upcrossings[1].rate", "peaks[2].rate"}) {
    for (const double relative : {0.5, -0.2}) {
      const auto found = moved_by(scaled("mcs", path, relative));
      ASSERT_EQ(found.size(), 1u) << path;
      EXPECT_EQ(found[0].kind, CheckedQuantityKind::simulated);
    }
  }
  EXPECT_GE(moved_by([](results::Run& run) {
              for (auto& o : solution(run, "mcs").metrics) {
                if (o.path.starts_with("upcrossings") && o.path.ends_with("rate")) scale(o, 1);
              }
            }).size(),
            8u);
}

TEST(MetricQuantities, ComparesStandardErrors) {
  using Errors = std::vector<double*> (*)(transform::Solution&);
  const Errors typed = [](transform::Solution& mcs) {
    return std::vector<double*>{&mcs.standard_errors->moments.y2,
                                &mcs.standard_errors->energy_residual, &*mcs.sampling->y,
                                &*mcs.sampling->ydot_99};
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const auto by = [&](double factor) {
      return moved_by([&](results::Run& run) { *typed(solution(run, "mcs"))[k] *= factor; }).size();
    };
    for (const double factor : {2.0, 0.5, 100.0, 0.01}) EXPECT_EQ(by(factor), 1u) << k;
    EXPECT_EQ(by(1.3), 0u) << k;
    EXPECT_GE(by(NAN), 1u) << k;
  }
  for (const std::string path :
       {"impact_rate_error", "joint_moments[3].standard_error", "peaks[1].standard_error"}) {
    for (const double factor : {2.0, 0.5, 100.0, 0.01}) {
      EXPECT_EQ(moved_by(scaled("mcs", path, factor - 1)).size(), 1u) << path << factor;
    }
    EXPECT_TRUE(moved_by(scaled("mcs", path, 0.3)).empty()) << path;
  }
  EXPECT_EQ(moved_by(scaled("mcs", "effective_samples", 3)).size(), 1u);
  // Errors that are too wide are found themselves.
  EXPECT_GE(moved_by([](results::Run& run) {
              auto& mcs = solution(run, "mcs");
              for (const auto& of : transform::kMoments)
                mcs.standard_errors->moments.*of.moment *= 100;
              scale(mcs.moments.y2, 0.02);
            }).size(),
            6u);
}

TEST(MetricQuantities, ARunWithoutErrorsAndOneWithThemAreNotTheSame) {
  EXPECT_GE(
      moved_by([](results::Run& run) { solution(run, "mcs").standard_errors.reset(); }).size(), 1u);
  EXPECT_GE(moved_by([](results::Run& run) { solution(run, "mcs").sampling.reset(); }).size(), 1u);
}

}  // namespace
}  // namespace fpkcheck::check
