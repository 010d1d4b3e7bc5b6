#include "methods/external/external_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "exact/closed_forms.hpp"
#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/external/external_labels.hpp"
#include "methods/external/external_samples.hpp"
#include "methods/external/range_between_walls.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "refusal.hpp"
#include "saved_run.hpp"

namespace fpkcheck::methods {
namespace {

using problem::DensityEquation;
using tests::contains;
using tests::refusal;
using transform::StateVariable;
using transform::Status;
using Function = std::function<double(double, double)>;

// External densities at r = 1, where the density under white noise is known exactly.
class ExternalDensities : public testing::Test {
 protected:
  Method of(const Function& p,
            const ExternalDensity& own = {.label = "own", .equation = DensityEquation::white},
            const JointDensityOptions& how = {}) {
    std::vector<double> values;
    for (const double y : points_.y_points()) {
      for (const double v : points_.v_points()) values.push_back(p(y, v));
    }
    return make_method_from_density_values(own, how, points_, values);
  }
  Method of_samples(const ExternalDensity& own, StateSamples samples) {
    return make_method_from_samples(own, transform::kExternalFunction, std::move(samples));
  }
  transform::Solution solved(const Method& method) {
    return solve_with_method(method, problem_, {axes_, {}});
  }

  problem::Problem problem_ = tests::make_problem({.restitution = 1});
  compare::ComparisonBins axes_ = compare::comparison_bins(problem_);
  DensityQuadratureGrid points_{axes_, problem_.system.walls()};
  exact::WhiteNoiseDensity exact_{problem_};
};

TEST_F(ExternalDensities, ReproduceTheFunction) {
  const auto own = solved(of([&](double y, double v) { return 5 * exact_(y, v); }));
  EXPECT_EQ(own.status, Status::ok);
  EXPECT_NEAR(own.mass, 1, 1e-9);
  EXPECT_NEAR(own.moments.v2, 0.5, 1e-8);
  EXPECT_NEAR(own.moments.v4, 0.75, 1e-7);
  EXPECT_NEAR(own.energy_residual, 0, 1e-8);
  EXPECT_NEAR(transform::metric_number(own.metrics, "normalised_by").value(), 2.5, 1e-8);
  EXPECT_NEAR(transform::metric_number(own.metrics, "balances.virial").value(), 0, 1e-7);
  EXPECT_NEAR(transform::metric_number(own.metrics, "balances.momentum").value(), 0, 1e-7);
  EXPECT_EQ(transform::equation_and_impact_text(own.identity), "white/map");
  const auto y = transform::marginal(own, StateVariable::y, axes_.y_edges);
  // The average over a bin differs from the density at its centre.
  for (const std::size_t b : {0, 20, 70}) {
    EXPECT_NEAR(y.density[b] / exact_.displacement_marginal(y.bin_centre(b)), 1, 3e-3);
  }
}

TEST_F(ExternalDensities, AreClosuresWithABudgetIfTheirEquationIsGiven) {
  const Function p = [&](double y, double v) { return exact_(y, v); };
  auto methods = builtin_registry().methods_selected_by_list("fd-white,fd-kf", {});
  methods.insert(methods.begin(), of(p, {.label = "nobody"}));
  methods.insert(methods.begin() + 1,
                 of(p, {.label = "own", .equation = DensityEquation::white}, {.accuracy = 1}));
  const auto one = run_cases({problem_}, methods, 0, {}).front();
  const auto& own = *one.find("own");
  EXPECT_EQ(own.identity.role, transform::SolutionRole::closure);
  EXPECT_EQ(one.find("nobody")->identity.role, transform::SolutionRole::external);
  EXPECT_EQ(own.status, Status::ok);
  // The error against the full problem is that of the white-noise model.
  const double far = one.l1_distance("own", "fd-kf", StateVariable::y).value();
  EXPECT_GT(own.error.value().y_l1, far);
  EXPECT_LT(own.error.value().y_l1, 1.7 * far);
  ASSERT_EQ(one.budget.size(), 2u);
  for (const auto& row : one.budget) {
    EXPECT_EQ(row.solution, "own");
    EXPECT_LT(row.find_budget_part("closure")->l1, 1e-4);
    EXPECT_GT(row.find_budget_part("white noise")->l1, 0.01);
  }
  EXPECT_FALSE(builtin_registry().method_for_solution(own, {}));
}

TEST_F(ExternalDensities, AreInadmissibleIfNoDensity) {
  const auto status_of = [&](const Function& p, bool normalise = true) {
    const auto own = solved(of(p, {.label = "own", .equation = DensityEquation::kf},
                               {.normalise = normalise, .accuracy = 1}));
    return std::string(name(own.status)) + ": " + own.reason;
  };
  EXPECT_EQ(status_of([&](double y, double v) { return exact_(y, v); }, false),
            "inadmissible: the integral is 0.5, not 1");
  EXPECT_TRUE(contains(status_of([](double, double) { return 1; }), "), at y ="));
  EXPECT_TRUE(
      contains(status_of([&](double y, double v) { return exact_(y, v) * (2 - y); }), "negative"));
}

TEST_F(ExternalDensities, AreRefusedIfInvalid) {
  EXPECT_EQ(refusal([&] { of([](double y, double) { return 1 / y; }); }).find("density 'own': p(0"),
            0u);
  EXPECT_TRUE(contains(refusal([&] { of([](double, double) { return -1; }); }), "integral is -"));
  EXPECT_TRUE(contains(refusal([&] {
                         make_method_from_density_values({.label = "a"}, {}, points_, {1, 2});
                       }),
                       "2 values (must be 601 x 600)"));
  const std::vector<double> few(99, 1), many(100, 1), behind(100, -1), other(101, 1);
  const auto samples = [&](const auto& y, const auto& v, double independent = 0) {
    return refusal([&] { of_samples({.label = "a"}, {y, v, false, independent}).check(problem_); });
  };
  EXPECT_EQ(samples(few, few), "samples 'a': 99 samples (must be at least 100)");
  EXPECT_EQ(samples(many, other), "samples 'a': 100 of y and 101 of y' (must be equal)");
  EXPECT_TRUE(contains(samples(behind, many), "y = -1 (must be y >= 0)"));
  EXPECT_TRUE(contains(samples(many, many, 101), "independent = 101 (must be 0 .. 100"));
  EXPECT_EQ(samples(many, many, 100), "accepted");
  const auto all = builtin_registry();
  EXPECT_TRUE(
      contains(refusal([&] { require_valid_label("fd.kf", all); }), "is the name of a method"));
  EXPECT_TRUE(contains(refusal([&] { require_distinct_labels("a.b", "a-b"); }), "differ only in"));
  // The message must not name a command-line option: the caller used the library.
  for (const char* label : {"fd.kf", "a b"}) {
    EXPECT_FALSE(contains(refusal([&] { require_valid_label(label, all); }), "--")) << label;
  }
  EXPECT_EQ(refusal([&] { require_distinct_labels("a.b", "a.b"); }), "accepted");
}

TEST_F(ExternalDensities, SamplesEstimateTheirSamplingError) {
  constexpr int kSamples = 50'000;
  std::mt19937_64 engine(5);
  std::normal_distribution<double> normal(0, std::sqrt(0.5));
  std::vector<double> y, v;
  for (int k = 0; k < kSamples; ++k) {
    y.push_back(std::abs(normal(engine)));
    v.push_back(normal(engine));
  }
  const auto drawn =
      solved(of_samples({.label = "drawn", .equation = DensityEquation::white}, {y, v}));
  const auto exact = solved(of([](double a, double b) { return std::exp(-a * a - b * b); }));
  for (const auto variable : transform::kVariables) {
    const auto& edges = compare::comparison_bin_edges(axes_, variable);
    const double far =
        l1_distance(marginal(drawn, variable, edges), marginal(exact, variable, edges));
    const double expected = transform::expected_l1_error(*drawn.sampling, variable).value();
    EXPECT_NEAR(far / expected, 1, 0.3);
    EXPECT_LT(far, transform::l1_error_quantile_99(*drawn.sampling, variable).value());
  }
  EXPECT_NEAR(drawn.mass, 1, 1e-9);
  EXPECT_NEAR(drawn.moments.v2, 0.5, 4 * drawn.standard_errors->moments.v2);
  EXPECT_NEAR(drawn.standard_errors->moments.v2, 0.5 * std::sqrt(2.0 / kSamples), 1e-4);
  // A quarter as many independent samples double the errors.
  const auto fewer = solved(of_samples({.label = "a"}, {y, v, false, kSamples / 4.0}));
  EXPECT_NEAR(fewer.sampling->y.value() / drawn.sampling->y.value(), 2, 1e-9);
  EXPECT_NEAR(fewer.standard_errors->moments.y1 / drawn.standard_errors->moments.y1, 2, 1e-9);
}

// An autoregressive sequence x_{k+1} = rho x_k + .. has the standard deviation 1 and the
// correlation time 1 / (1 - rho) samples.
std::vector<double> autoregressive_sequence(double rho, int count, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  std::vector<double> sequence{normal(engine)};
  for (int k = 1; k < count; ++k) {
    sequence.push_back(rho * sequence.back() + std::sqrt(1 - rho * rho) * normal(engine));
  }
  return sequence;
}

// The folded normal law |x| is the exact law of the samples. Intervals from independent samples
// would cover the exact probabilities in less than half of the bins.
TEST_F(ExternalDensities, TimeSeriesEstimateTheirSamplingError) {
  constexpr int kSeries = 40, kSamples = 5'000;
  std::mt19937_64 engine(5);
  int covered = 0, bins = 0;
  double distance = 0, expected = 0, above_quantile = 0, squared_moment_errors = 0;
  for (int series = 0; series < kSeries; ++series) {
    std::vector<double> y = autoregressive_sequence(0.9, kSamples, engine);
    for (double& value : y) value = std::abs(value);
    const auto solution =
        solved(of_samples({.label = "a"}, {.y = y, .v = {}, .is_time_series = true}));
    EXPECT_EQ(solution.status, Status::ok);
    EXPECT_FALSE(solution.density);
    EXPECT_TRUE(std::isnan(solution.moments.v2));
    const auto found = marginal(solution, StateVariable::y, axes_.y_edges);
    double l1 = 0;
    for (std::size_t b = 0; b < found.size(); ++b) {
      const double width = axes_.y_edges[b + 1] - axes_.y_edges[b];
      const double exact = (std::erf(axes_.y_edges[b + 1] / std::numbers::sqrt2) -
                            std::erf(axes_.y_edges[b] / std::numbers::sqrt2)) /
                           width;
      l1 += std::abs(found.density[b] - exact) * width;
      if (exact * width * kSamples < 100) continue;
      ++bins;
      covered += found.lower[b] <= exact && exact <= found.upper[b];
    }
    distance += l1 / kSeries;
    expected += solution.sampling->y.value() / kSeries;
    above_quantile += l1 > solution.sampling->y_99.value();
    squared_moment_errors +=
        std::pow((solution.moments.y2 - 1) / solution.standard_errors->moments.y2, 2) / kSeries;
  }
  EXPECT_NEAR(static_cast<double>(covered) / bins, 0.95, 0.03);
  EXPECT_NEAR(distance / expected, 1, 0.15);
  EXPECT_LE(above_quantile, 3);
  // Blocks of finite length underestimate the variance by about 10 %.
  EXPECT_NEAR(squared_moment_errors, 1.1, 3 * std::sqrt(2.0 / kSeries));
}

// y = Re z with z_{k+1} = exp(-(c/2 + i w) dt) z_k + .. has 1260 samples per period and the mean
// square 1; the squares decorrelate in the time 1/c of 2000 samples.
TEST_F(ExternalDensities, TimeSeriesOfAnOscillationEstimateTheirSamplingError) {
  constexpr int kSeries = 20, kSamples = 100'000;
  constexpr double kStep = 0.005, kDamping = 0.1, kFrequency = 1;
  const auto linear =
      tests::with_noise(problem::System({.damping = 0.1, .stiffness = 1}, {.none = true}), 0.2);
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-kDamping / 2 * kStep);
  const double cosine = decay * std::cos(kFrequency * kStep),
               sine = decay * std::sin(kFrequency * kStep), noise = std::sqrt(1 - decay * decay);
  double squared_moment_errors = 0;
  for (int series = 0; series < kSeries; ++series) {
    double x = normal(engine), z = normal(engine);
    StateSamples samples{.y = {}, .v = {}, .is_time_series = true};
    for (int k = 0; k < kSamples; ++k) {
      samples.y.push_back(x);
      const double previous = x;
      x = cosine * x + sine * z + noise * normal(engine);
      z = cosine * z - sine * previous + noise * normal(engine);
    }
    const auto solution = solve_with_method(of_samples({.label = "a"}, std::move(samples)), linear,
                                            {compare::comparison_bins(linear), {}});
    squared_moment_errors +=
        std::pow((solution.moments.y2 - 1) / solution.standard_errors->moments.y2, 2) / kSeries;
  }
  EXPECT_NEAR(squared_moment_errors, 1, 3 * std::sqrt(2.0 / kSeries));
}

TEST_F(ExternalDensities, TimeSeriesShorterThanTheirCorrelationsAreInaccurate) {
  std::mt19937_64 engine(5);
  std::vector<double> y = autoregressive_sequence(0.99, 500, engine);
  for (double& value : y) value = std::abs(value);
  const auto solution =
      solved(of_samples({.label = "a"}, {.y = y, .v = {}, .is_time_series = true}));
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_TRUE(contains(solution.reason, "record longer"));
}

TEST_F(ExternalDensities, AreTheReferenceOnRequest) {
  std::mt19937_64 engine(5);
  std::vector<double> y = autoregressive_sequence(0, 1000, engine);
  for (double& value : y) value = std::abs(value);
  auto methods = builtin_registry().methods_selected_by_list("fd-kf", {});
  methods.push_back(of_samples({.label = "lab", .is_reference = true}, {.y = y, .v = {}}));
  const auto one = run_cases({problem_}, methods, 0, {}).front();
  EXPECT_EQ(one.assessment.reference, "lab");
  EXPECT_TRUE(one.assessment.is_reference_chosen_by_user);
  const auto* fd = one.assessment.find_solution_assessment("fd-kf");
  ASSERT_NE(fd, nullptr);
  EXPECT_TRUE(fd->y);
  EXPECT_FALSE(fd->ydot);
}

}  // namespace
}  // namespace fpkcheck::methods
