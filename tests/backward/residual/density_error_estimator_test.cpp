#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "backward/bounds/bounds_from_grid.hpp"
#include "backward/residual/density_error_estimator.hpp"
#include "exact/linear_density.hpp"
#include "exact/linear_moments.hpp"
#include "exact/linear_problem.hpp"
#include "residual/gaussian_density.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::backward {
namespace {

using tests::gaussian_density;
using tests::kSigmaV;
using tests::kSigmaY;

/// Exact moments of the Gaussian, which differ from the moments of the cases by some per cent.
const transform::Moments kGaussianMoments{.y1 = kSigmaY * std::sqrt(2 / std::numbers::pi),
                                          .y2 = kSigmaY * kSigmaY,
                                          .y4 = 3 * std::pow(kSigmaY, 4),
                                          .v1 = 0,
                                          .v2 = kSigmaV * kSigmaV,
                                          .v4 = 3 * std::pow(kSigmaV, 4)};

/// Exact averages of the Gaussian over cells.
transform::GridDensity gaussian_averages(const std::vector<double>& y,
                                         const std::vector<double>& v) {
  const auto part = [](const std::vector<double>& edges, std::size_t k, double s) {
    const double unit = s * std::numbers::sqrt2;
    return (std::erf(edges[k + 1] / unit) - std::erf(edges[k] / unit)) / (edges[k + 1] - edges[k]);
  };
  transform::GridDensity grid{y, v, {}};
  for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
      grid.averages.push_back(part(y, i, kSigmaY) * part(v, j, kSigmaV) / 2);
    }
  }
  return grid;
}

const DensityErrorEstimator& case_1_estimator() {
  static const DensityErrorEstimator estimator(tests::paper_case(1));
  return estimator;
}

TEST(DensityResiduals, EstimateTheErrorsOfAWrongDensity) {
  const auto found = case_1_estimator().estimate_errors(gaussian_density());
  EXPECT_NEAR(found.mass, 1, 1e-12);
  // Errors of 0.03 and 0.05 are found to 3e-9 (reference: many simulations).
  EXPECT_NEAR(found.corrected_moments.y2, 0.3945181772, 3e-9);
  EXPECT_NEAR(found.corrected_moments.v2, 0.4415122125, 3e-9);
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    EXPECT_NEAR(found.moment_errors.*moment + found.corrected_moments.*moment,
                kGaussianMoments.*moment, 1e-10)
        << name;
  }
}

TEST(DensityResiduals, CorrectAnyDensityIntoTheGuaranteedBounds) {
  const std::vector<StationaryFunctional> functionals{
      PowerMoment{StateVariable::y, 1}, PowerMoment{StateVariable::y, 2},
      PowerMoment{StateVariable::y, 4}, PowerMoment{StateVariable::ydot, 2},
      PowerMoment{StateVariable::ydot, 4}};
  double transform::Moments::*const moments[] = {&transform::Moments::y1, &transform::Moments::y2,
                                                 &transform::Moments::y4, &transform::Moments::v2,
                                                 &transform::Moments::v4};
  for (const auto& problem :
       {tests::paper_case(1),
        tests::make_problem({.restitution = 0.7, .mean = 0.1, .law = "uniform"})}) {
    const auto bounds = compute_bounds_on_grid(
        problem, make_residual_weight(problem, 12),
        spline_grid_sequence(BoundWidthLimitingFeature::conical_point)[0], functionals, 1);
    const auto found = DensityErrorEstimator(problem).estimate_errors(gaussian_density());
    for (std::size_t k = 0; k < functionals.size(); ++k) {
      const double value = found.corrected_moments.*moments[k];
      EXPECT_TRUE(bounds[k].contains(value)) << functional_name(functionals[k]) << ' ' << value
                                             << " in " << bounds[k].lower << ' ' << bounds[k].upper;
      // The bounds are narrow: their half-width is below a fourth of the error.
      EXPECT_GT(std::abs(found.moment_errors.*moments[k]), 4 * bounds[k].half_width());
    }
    EXPECT_NEAR(found.corrected_moments.v1, 0, 1e-9);
  }
}

TEST(DensityResiduals, OfCellAveragesConvergeToThoseOfTheFunction) {
  const auto exact = case_1_estimator().estimate_errors(gaussian_density()).moment_errors;
  std::vector<double> worst;
  for (const int cells : {24, 36, 54}) {
    const auto grid = gaussian_averages(tests::uniform_edges(0, 8 * kSigmaY, cells),
                                        tests::uniform_edges(-8 * kSigmaV, 8 * kSigmaV, 2 * cells));
    const auto found = case_1_estimator().estimate_errors(grid).moment_errors;
    worst.push_back(0);
    for (const auto& [name, symbol, moment, size] : transform::kMoments) {
      worst.back() = std::max(worst.back(), std::abs(found.*moment - exact.*moment));
    }
  }
  EXPECT_LT(worst[2], 1e-8);
  for (const std::size_t k : {0U, 1U}) {
    const double order = std::log(worst[k] / worst[k + 1]) / std::log(1.5);
    EXPECT_GT(order, 6.2) << worst[k] << ' ' << worst[k + 1];
    EXPECT_LT(order, 9.5) << worst[k] << ' ' << worst[k + 1];
  }
  // Averages computed with three Gauss points have an error of sixth order.
  const auto average_over_cells =
      transform::average_over_cells(gaussian_density(), tests::uniform_edges(0, 8 * kSigmaY, 72),
                                    tests::uniform_edges(-8 * kSigmaV, 8 * kSigmaV, 144));
  const auto found = case_1_estimator().estimate_errors(average_over_cells).moment_errors;
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    EXPECT_NEAR(found.*moment, exact.*moment, 1e-7) << name;
  }
}

TEST(DensityResiduals, FindNoErrorInTheExactSolution) {
  const auto problem = tests::linear_problem({.law = "laplace"});
  const exact::LinearDensity exact(problem);
  const auto y = tests::uniform_edges(0, 8, 80), v = tests::uniform_edges(-8, 8, 160);
  const auto found = DensityErrorEstimator(problem).estimate_errors(
      transform::GridDensity{y, v, exact.joint_averages(y, v)});
  const auto known = exact::linear_moments_at(problem, {}, 1e4);
  EXPECT_NEAR(found.corrected_moments.y2, known.zz, 1e-8);
  EXPECT_NEAR(found.corrected_moments.v2, known.vv, 1e-8);
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    EXPECT_NEAR(found.moment_errors.*moment, 0, 1e-7) << name;
  }
}

double marginal_l1_distance(const std::vector<double>& a, const std::vector<double>& b,
                            const std::vector<double>& edges) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += std::abs(a[k] - b[k]) * (edges[k + 1] - edges[k]);
  }
  return sum;
}

TEST(DensityResiduals, EstimateTheL1ErrorsOfMarginals) {
  // The Gaussian has an error of about a quarter; its marginals and the exact marginals are known.
  for (const char* law : {"gaussian", "uniform", "laplace"}) {
    const auto problem = tests::linear_problem({.law = law});
    const exact::LinearDensity exact(problem);
    const auto found = DensityErrorEstimator(problem).estimate_errors(gaussian_density());
    const auto y = tests::uniform_edges(0, 8, 400), v = tests::uniform_edges(-8, 8, 800);
    std::vector<double> of_y, of_v;
    for (std::size_t k = 0; k + 1 < y.size(); ++k) {
      const double unit = kSigmaY * std::numbers::sqrt2;
      of_y.push_back((std::erf(y[k + 1] / unit) - std::erf(y[k] / unit)) / (y[k + 1] - y[k]));
    }
    for (std::size_t k = 0; k + 1 < v.size(); ++k) {
      const double unit = kSigmaV * std::numbers::sqrt2;
      of_v.push_back((std::erf(v[k + 1] / unit) - std::erf(v[k] / unit)) / (v[k + 1] - v[k]) / 2);
    }
    const double y_true = marginal_l1_distance(of_y, exact.displacement_averages(y), y);
    const double v_true = marginal_l1_distance(of_v, exact.velocity_averages(v), v);
    EXPECT_GT(y_true, 0.1) << law;
    // Bins underestimate an error that changes sign within a bin.
    EXPECT_NEAR(found.y_l1.dual_weighted_error / y_true, 0.94, 0.06) << law;
    EXPECT_NEAR(found.ydot_l1.dual_weighted_error / v_true, 0.94, 0.06) << law;
    const auto error_estimate = found.error_estimate();
    ASSERT_TRUE(error_estimate) << law;
    EXPECT_GT(error_estimate->y_l1, y_true) << law;
    EXPECT_LT(error_estimate->y_l1, 1.8 * y_true) << law;
    EXPECT_GT(error_estimate->ydot_l1, v_true) << law;
    EXPECT_LT(error_estimate->ydot_l1, 1.8 * v_true) << law;
    EXPECT_GE(error_estimate->moments.y2, std::abs(found.moment_errors.y2)) << law;
  }
}

TEST(DensityResiduals, OnWideCellsDifferByLessThanTheUnresolvedResidual) {
  // With strong losses few cells do not resolve the backward equation.
  const auto problem = tests::make_problem({.restitution = 0.5, .rate = 0.5});
  const DensityErrorEstimator fine(problem), wide(problem, {.y_cells = 32, .v_cells = 64});
  const auto known = fine.estimate_errors(gaussian_density()),
             found = wide.estimate_errors(gaussian_density());
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const auto& [name, symbol, moment, size] = transform::kMoments[k];
    const double off = std::abs(found.moment_errors.*moment - known.moment_errors.*moment);
    EXPECT_LT(off, 2 * (found.unresolved_residuals[k] + known.unresolved_residuals[k])) << name;
    EXPECT_LT(known.unresolved_residuals[k], found.unresolved_residuals[k] + 1e-9) << name;
  }
}

TEST(ErrorEstimate, IncreasesWithTheUnresolvedResidual) {
  DensityErrorEstimates errors{};
  const auto error_estimate = [&](double found, double unresolved, double contrast = 0) {
    errors.y_l1 = {found, unresolved, contrast};
    const auto error = errors.error_estimate();
    return error ? error->y_l1 / DensityErrorEstimates::kSubBinFactor : -1;
  };
  EXPECT_DOUBLE_EQ(error_estimate(0.01, 0), 0.01);
  EXPECT_DOUBLE_EQ(error_estimate(0.01, 0.02), 0.01 / 0.8);  // t = 0.01 + 10 t 0.02
  EXPECT_DOUBLE_EQ(error_estimate(0.5, 0.02), 0.54);         // at most twice the unresolved part
  EXPECT_DOUBLE_EQ(error_estimate(0, 0.2), 0.4);             // unresolved part only
  EXPECT_DOUBLE_EQ(error_estimate(0.01, 0, 0.5),
                   0.02);  // residuals contain half of the wells' error
  EXPECT_DOUBLE_EQ(error_estimate(0.01, 0.02, 0.3), 0.02);  // t = 0.01 + 10 t 0.02 + 0.3 t
  EXPECT_EQ(error_estimate(0, 0.7), -1);     // the estimate would reach 2, the largest L1 distance
  EXPECT_EQ(error_estimate(0, 0, 0.6), -1);  // contrast above kMaxContrast
}

TEST(DensityResiduals, DoNotDependOnTheUnitOfTheDensity) {
  auto twice = gaussian_density();
  twice.value = [one = gaussian_density().value](double y, double v) { return 2 * one(y, v); };
  const auto once = case_1_estimator().estimate_errors(gaussian_density()),
             found = case_1_estimator().estimate_errors(twice);
  EXPECT_NEAR(found.mass, 2, 1e-12);
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    EXPECT_NEAR(found.moment_errors.*moment, once.moment_errors.*moment, 1e-13);
    EXPECT_NEAR(found.corrected_moments.*moment, once.corrected_moments.*moment, 1e-13);
  }
  EXPECT_LT((found.moment_error_contributions[1] - once.moment_error_contributions[1])
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
}

TEST(DensityResiduals, WeightByTheCentredSolution) {
  // For E[y'] the solution is h = -y + constant: the weight is y - E_p[y].
  const auto integrals =
      WeakResidualIntegrator(tests::paper_case(1),
                             {case_1_estimator().y_splines(), case_1_estimator().v_splines()})
          .integrate_density(gaussian_density());
  const auto y = case_1_estimator().y_splines().coefficients_of_monomial(1);
  Eigen::MatrixXd expected = integrals.weak_residuals;
  for (Eigen::Index i = 0; i < expected.rows(); ++i) {
    expected.row(i) *= y[static_cast<std::size_t>(i)] - kGaussianMoments.y1;
  }
  const double largest = expected.cwiseAbs().maxCoeff();
  EXPECT_LT((case_1_estimator().estimate_errors(gaussian_density()).moment_error_contributions[3] -
             expected)
                .cwiseAbs()
                .maxCoeff(),
            1e-4 * largest);
}

TEST(DensityResiduals, SpreadSumsToTheError) {
  const auto found = case_1_estimator().estimate_errors(gaussian_density());
  const auto &y_splines = case_1_estimator().y_splines(),
             &v_splines = case_1_estimator().v_splines();
  const auto y = tests::uniform_edges(0, y_splines.end(), 23),
             v = tests::uniform_edges(v_splines.begin(), v_splines.end(), 31);
  const double area = (y[1] - y[0]) * (v[1] - v[0]);
  for (std::size_t k = 0; k < kMomentCount; ++k) {
    const Eigen::MatrixXd map = case_1_estimator().distribute_contributions_over_cells(
        found.moment_error_contributions[k], y, v);
    EXPECT_EQ(map.rows(), 23);
    EXPECT_EQ(map.cols(), 31);
    EXPECT_NEAR(map.sum() * area, found.moment_errors.*transform::kMoments[k].moment, 1e-12);
  }
}

TEST(DensityResiduals, LocateALocalError) {
  // The exact solution plus a perturbation of zero mass, antisymmetric about (0.9, 0.6).
  const auto problem = tests::linear_problem();
  const exact::LinearDensity exact(problem);
  const DensityErrorEstimator estimator(problem);
  const auto y = tests::uniform_edges(0, 7, 70), v = tests::uniform_edges(-7, 7, 140);
  transform::GridDensity grid{y, v, exact.joint_averages(y, v)};
  constexpr double kHeight = 0.05;
  const double y0 = 0.9, v0 = 0.6, width = 0.15;
  for (std::size_t i = 0; i < grid.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < grid.v_cell_count(); ++j) {
      const double a = ((y[i] + y[i + 1]) / 2 - y0) / width,
                   b = ((v[j] + v[j + 1]) / 2 - v0) / width;
      grid.averages[i * grid.v_cell_count() + j] += kHeight * a * std::exp(-(a * a + b * b) / 2);
    }
  }
  const auto found = estimator.estimate_errors(grid);
  EXPECT_NEAR(found.moment_errors.y2, kHeight * 4 * std::numbers::pi * y0 * std::pow(width, 3),
              1e-6);
  const Eigen::MatrixXd map =
      estimator.distribute_contributions_over_cells(found.moment_error_contributions[1], y, v)
          .cwiseAbs();
  double near = 0, height = 0, speed = 0;
  for (Eigen::Index i = 0; i < map.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.cols(); ++j) {
      const double at_y = 0.05 + 0.1 * static_cast<double>(i),
                   at_v = -6.95 + 0.1 * static_cast<double>(j);
      height += at_y * map(i, j) / map.sum();
      speed += at_v * map(i, j) / map.sum();
      if (std::hypot(at_y - y0, at_v - v0) < 5 * width) near += map(i, j) / map.sum();
    }
  }
  EXPECT_GT(near, 0.9);
  EXPECT_NEAR(height, y0, 0.2);
  EXPECT_NEAR(speed, v0, 0.1);
}

}  // namespace
}  // namespace fpkcheck::backward
