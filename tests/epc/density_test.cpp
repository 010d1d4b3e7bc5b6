#include "epc/closed_form_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "closures.hpp"
#include "epc/solve.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "refusal.hpp"
#include "transform/coordinate_transformation.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Metrics;
using transform::SolverMetricsBuilder;

const transform::SmoothDensity& smooth_density_of(const ClosureResult& result) {
  return std::get<transform::SmoothDensity>(*result.solution.density);
}

// The closed form in files reproduces the solver's density inside and outside its support.
void expect_closed_form_reproduces_density(const problem::Problem& problem,
                                           const ClosureOptions& options) {
  const ClosureResult result = solve_closure(problem, options);
  ASSERT_TRUE(result.solution.density) << result.solution.reason;
  const auto form = read_closed_form(result.solution.metrics);
  EXPECT_TRUE(can_be_normalised(form));
  const auto& solver_density = smooth_density_of(result);
  const auto again = density_of_closed_form(form, &problem);
  EXPECT_EQ(again.y_max, solver_density.y_max);
  EXPECT_EQ(again.v_max, solver_density.v_max);
  double peak = 0;
  for (int i = 0; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) {
      const double y = 1.1 * solver_density.y_max * i / 20, v = 1.1 * solver_density.v_max * j / 20;
      const double p = solver_density.value(y, v);
      EXPECT_NEAR(again.value(y, v), p, 1e-12 * p) << solution_id(options) << ' ' << y << ' ' << v;
      peak = std::max(peak, p);
    }
  }
  EXPECT_GT(peak, 0.01);
}

TEST(ClosedForm, EvaluatesToTheSolversDensity) {
  expect_closed_form_reproduces_density(tests::paper_case(2), {.order = 6});
  expect_closed_form_reproduces_density(tests::paper_case(1),
                                        {.order = 4, .monomials = MonomialSet::general});
  expect_closed_form_reproduces_density(tests::paper_case(1),
                                        tests::closure_options(Formulation::moment, 4));
  expect_closed_form_reproduces_density(tests::paper_case(1),
                                        tests::closure_options(Formulation::polar, 4));
  auto cut = tests::closure_options(Formulation::moment, 4);
  cut.tail = DensityTailTreatment::cut;
  expect_closed_form_reproduces_density(tests::paper_case(1), cut);
}

// Files store a solution in the coordinates of its frame, with the frame. The density read from
// them is in physical coordinates.
TEST(ClosedForm, EvaluatesOnThePhysicalAxesWhateverTheFrame) {
  using problem::System;
  const auto impulses = tests::gaussian_impulses(1, 0.1);
  const problem::Problem problems[] = {
      tests::with_impulses(System({.damping = 0.1, .stiffness = 1}, {.none = true}), impulses),
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.left = -0.5, .left_restitution = 0.9}),
          impulses),
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.right = 0.4, .right_restitution = 0.9}),
          impulses),
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1}, {.right = 0, .right_restitution = 0.9}),
          impulses),
      tests::with_impulses(
          System({.damping = 0.1, .stiffness = 1},
                 {.left = -0.5, .left_restitution = 0.9, .right = 1, .right_restitution = 0.8}),
          impulses)};
  const auto expect_the_same_in_any_frame = [](const problem::Problem& physical,
                                               const ClosureOptions& options) {
    const auto seen = tests::in_wall_coordinates(physical);
    if (!unsupported_reason(seen, options).empty()) return;
    const ClosureResult result = solve_closure(seen, options);
    ASSERT_TRUE(result.solution.density) << result.solution.reason;
    const auto solver_density = std::get<transform::SmoothDensity>(
        transform::to_physical_coordinates(seen.frame, *result.solution.density));
    const auto form = read_closed_form(result.solution.metrics);
    for (const auto* problem : {&physical, &seen}) {
      const auto again = density_of_closed_form(form, problem);
      EXPECT_EQ(again.y_min, solver_density.y_min);
      EXPECT_EQ(again.y_max, solver_density.y_max);
      const double width = solver_density.y_max - solver_density.y_min;
      double peak = 0;
      for (int i = -2; i <= 22; ++i) {
        for (int j = -20; j <= 20; ++j) {
          const double y = solver_density.y_min + width * i / 20,
                       v = 1.1 * solver_density.v_max * j / 20;
          const double p = solver_density.value(y, v);
          EXPECT_NEAR(again.value(y, v), p, 1e-12 * p) << y << ' ' << v;
          peak = std::max(peak, p);
        }
      }
      EXPECT_GT(peak, 0.01) << solution_id(options);
    }
  };
  for (const auto& physical : problems) {
    expect_the_same_in_any_frame(physical, tests::closure_options(Formulation::gaussian, 2));
    expect_the_same_in_any_frame(physical, tests::closure_options(Formulation::moment, 4));
    expect_the_same_in_any_frame(physical, tests::closure_options(Formulation::polar, 4));
  }
}

TEST(ClosedForm, IsRefusedWithAnOscillatorThatHasNoWallAtItsOrigin) {
  const auto of_gap = [](double wall) {
    return tests::with_impulses(
        problem::System({.damping = 0.1, .stiffness = 1}, {.left = wall, .left_restitution = 0.9}),
        tests::gaussian_impulses(1, 0.1));
  };
  const ClosureResult result = solve_closure(tests::in_wall_coordinates(of_gap(-0.5)),
                                             tests::closure_options(Formulation::moment, 4));
  const auto form = read_closed_form(result.solution.metrics);
  const auto other = of_gap(-0.6);
  EXPECT_THROW(density_of_closed_form(form, &other), InputError);
}

// The density proportional to exp(-y^2/2a^2 - v^2/2b^2), a = 0.5, b = 0.8.
constexpr double kA = 0.5, kB = 0.8;
SolverMetricsBuilder gaussian_form_metrics(const char* coordinates) {
  SolverMetricsBuilder builder;
  builder.add_text_metric("coordinates", std::string(coordinates))
      .add_result_metric("coefficients[0].x1", std::int64_t{2})
      .add_result_metric("coefficients[0].x2", std::int64_t{0})
      .add_result_metric("coefficients[0].a", -1 / (2 * kA * kA))
      .add_result_metric("coefficients[1].x1", std::int64_t{0})
      .add_result_metric("coefficients[1].x2", std::int64_t{2})
      .add_result_metric("coefficients[1].a", -1 / (2 * kB * kB));
  return builder;
}
double exact_gaussian_density(double y, double v) {
  return std::exp(-y * y / (2 * kA * kA) - v * v / (2 * kB * kB)) / (M_PI * kA * kB);
}

TEST(ClosedForm, OfAGaussianIsThatGaussian) {
  const auto expect_exact = [](SolverMetricsBuilder builder, double relative) {
    const auto p = density_of_closed_form(read_closed_form(builder.take_metrics()), nullptr);
    for (const double y : {0.0, 0.3, 1.1}) {
      for (const double v : {-2.0, 0.0, 0.7}) {
        EXPECT_NEAR(p.value(y, v) / exact_gaussian_density(y, v), 1, relative) << y << ' ' << v;
      }
    }
  };
  // Forms that the constant normalises: on the plane and on the half-plane.
  expect_exact(gaussian_form_metrics("x1,x2").add_result_metric("C", 1 / (2 * M_PI * kA * kB)),
               1e-14);
  expect_exact(
      gaussian_form_metrics("x1,x2").add_result_metric("log_C", -std::log(2 * M_PI * kA * kB)),
      1e-14);
  expect_exact(gaussian_form_metrics("y,v").add_result_metric("C", 1 / (M_PI * kA * kB)), 1e-14);
  // Forms that are normalised over a support with nearly all of the probability.
  expect_exact(gaussian_form_metrics("x1,x2")
                   .add_result_metric("support.sigma1", kA)
                   .add_result_metric("support.sigma2", kB),
               1e-12);
  expect_exact(gaussian_form_metrics("x1,x2")
                   .add_result_metric("support.y_max", 8 * kA)
                   .add_result_metric("support.v_max", 8 * kB),
               1e-12);
  expect_exact(gaussian_form_metrics("y,v")
                   .add_result_metric("support.y_max", 8 * kA)
                   .add_result_metric("support.v_max", 8 * kB),
               1e-12);
}

// A box that begins below 0 contains the whole Gaussian of the plane, with half the density.
TEST(ClosedForm, MayBeginBelowZero) {
  const auto p =
      density_of_closed_form(read_closed_form(gaussian_form_metrics("y,v")
                                                  .add_result_metric("support.y_max", 8 * kA)
                                                  .add_result_metric("support.y_min", -8 * kA)
                                                  .add_result_metric("support.v_max", 8 * kB)
                                                  .take_metrics()),
                             nullptr);
  EXPECT_NEAR(p.value(-0.3, 0.5) / (exact_gaussian_density(0.3, 0.5) / 2), 1, 1e-12);
  EXPECT_EQ(p.value(-8.1 * kA, 0), 0);
}

TEST(ClosedForm, WithoutConstantAndSupportIsNotNormalised) {
  const auto form = read_closed_form(gaussian_form_metrics("y,v").take_metrics());
  EXPECT_FALSE(can_be_normalised(form));
  EXPECT_DOUBLE_EQ(density_of_closed_form(form, nullptr).value(0, 0), 1);
}

std::string error_message(SolverMetricsBuilder builder, const problem::Problem* problem = nullptr) {
  return tests::refusal(
      [&] { density_of_closed_form(read_closed_form(builder.take_metrics()), problem); });
}

TEST(ClosedForm, ThatIsIncompleteIsRefused) {
  EXPECT_NE(error_message(SolverMetricsBuilder()).find("no \"coordinates\""), std::string::npos);
  EXPECT_NE(error_message(gaussian_form_metrics("q,p")).find("'q,p' (must be \"x1,x2\""),
            std::string::npos);
  EXPECT_NE(error_message(SolverMetricsBuilder().add_text_metric("coordinates", std::string("y,v")))
                .find("no coefficients"),
            std::string::npos);
  EXPECT_EQ(error_message(gaussian_form_metrics("y,v").add_result_metric("C", -1.0)),
            "\"C\" is -1 (must be positive)");
  EXPECT_NE(error_message(gaussian_form_metrics("y,v")
                              .add_result_metric("support.y_max", 1.0)
                              .add_result_metric("support.y_min", 2.0)
                              .add_result_metric("support.v_max", 1.0))
                .find("must be below"),
            std::string::npos);
  EXPECT_NE(error_message(gaussian_form_metrics("y,v").add_result_metric("support.y_max", 1.0))
                .find("incomplete support"),
            std::string::npos);
  EXPECT_NE(error_message(gaussian_form_metrics("y,v")
                              .add_result_metric("coefficients[2].x1", 0.5)
                              .add_result_metric("coefficients[2].x2", 0.0)
                              .add_result_metric("coefficients[2].a", 1.0))
                .find("is 0.5 (must be an integer"),
            std::string::npos);
  EXPECT_NE(error_message(gaussian_form_metrics("y,v")
                              .add_result_metric("coefficients[2].x1", 30.0)
                              .add_result_metric("coefficients[2].x2", 0.0)
                              .add_result_metric("coefficients[2].a", 1.0)
                              .add_result_metric("support.y_max", 9.0)
                              .add_result_metric("support.v_max", 9.0))
                .find("integral over the support is inf"),
            std::string::npos);
  // A form with amplitudes or energies needs an oscillator.
  EXPECT_NE(error_message(gaussian_form_metrics("amplitude,phase")).find("name its case"),
            std::string::npos);
  EXPECT_NE(error_message(gaussian_form_metrics("y,v").add_result_metric("support.energy", 1.0))
                .find("name its case"),
            std::string::npos);
  const auto problem = tests::paper_case(1);
  EXPECT_EQ(error_message(gaussian_form_metrics("amplitude,phase"), &problem), "accepted");
}

}  // namespace
}  // namespace fpkcheck::epc
