#include "fd_fpk/functionals/sensitivities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/solve.hpp"
#include "fd_fpk/stationary/parameter_derivatives.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/case_file.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;
using tests::uniform_edges;
using transform::ExpectationDerivatives;
using transform::MomentSensitivities;
using transform::Status;

const std::vector<double> kYEdges = uniform_edges(0, 4.4, 110),
                          kVelocityEdges = uniform_edges(-4.6, 4.6, 116);

MomentSensitivities sensitivities(const problem::Problem& p, const std::vector<std::string>& keys,
                                  const FiniteVolumeOptions& options = {}) {
  std::vector<problem::ParameterDifferenceQuotient> parameters;
  for (const auto& key : keys)
    parameters.push_back(problem::parameter_difference_quotient(p, key, 1e-4));
  return solve_sensitivities(p, options, parameters, kYEdges, kVelocityEdges);
}

const ExpectationDerivatives& of(const MomentSensitivities& s, const std::string& expectation) {
  return *std::ranges::find(s.expectations, expectation, &ExpectationDerivatives::expectation);
}

// E[y^2] = I / (2 c k), E[y'^2] = I / (2 c) with the intensity I of the impulses.
TEST(Sensitivities, AreExactForTheSecondMomentsOfTheLinearOscillator) {
  const double c = 0.3, k = 1.44, intensity = 0.1;
  const auto p = tests::with_impulses(System({.damping = c, .stiffness = k}, {.none = true}),
                                      tests::gaussian_impulses(1, intensity));
  const MomentSensitivities s =
      sensitivities(p, {"system.damping", "system.stiffness", "impulse.intensity", "impulse.rate"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const double y2 = intensity / (2 * c * k), v2 = intensity / (2 * c);
  const double exact_y2[] = {-y2 / c, -y2 / k, y2 / intensity, 0};
  const double exact_v2[] = {-v2 / c, 0, v2 / intensity, 0};
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_NEAR(of(s, "E[y^2]").derivatives[n], exact_y2[n], 1e-5 * y2 / c) << s.parameters[n];
    EXPECT_NEAR(of(s, "E[y'^2]").derivatives[n], exact_v2[n], 1e-5 * v2 / c) << s.parameters[n];
  }
  // E[y^4] = 3 E[y^2]^2 + lambda E[Y^4] int h^4 dt, and E[Y^4] = 3 (I/lambda)^2: at fixed intensity
  // the second term is inversely proportional to the rate.
  EXPECT_LT(of(s, "E[y^4]").derivatives[3], 0);
}

// With the scales of length and time a moment is a function of three parameters; the elasticities e
// then satisfy two identities for E[y^q] and for E[y'^q].
TEST(Sensitivities, SatisfyTheIdentitiesOfTheScalesOfLengthAndTime) {
  const auto p = tests::make_problem({.damping = 0.2, .restitution = 0.9});
  const MomentSensitivities s = sensitivities(
      p,
      {"system.damping", "system.stiffness", "system.cubic", "impulse.rate", "impulse.intensity"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  const struct {
    const char* expectation;
    double power;
    bool of_velocity;
  } moments[] = {{"E[y^2]", 2, false}, {"E[y^4]", 4, false}, {"E[y'^2]", 2, true}};
  for (const auto& [expectation, power, of_velocity] : moments) {
    const auto& one = of(s, expectation);
    const auto e = [&](std::size_t k) {
      return one.derivatives[k] * s.parameter_values[k] / one.value;
    };
    // The identities hold up to the errors of the finest grid.
    double errors = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      errors += 3 * one.errors[k] * s.parameter_values[k] / one.value;
    }
    EXPECT_LT(errors, 1e-3);
    EXPECT_NEAR(e(4), power / 2 + e(2), errors) << expectation;
    EXPECT_NEAR(e(0) + 2 * e(1) + 2 * e(2) + e(3) + 3 * e(4), of_velocity ? power : 0, errors)
        << expectation;
  }
}

TEST(Sensitivities, ToTheRestitutionAreThoseOfDifferencesOnTheSameGrid) {
  const FiniteVolumeOptions grid{.stepper = StationarySolver::direct,
                                 .nx = 40,
                                 .nv = 88,
                                 .x1_max = 4,
                                 .x2_max = 4.5,
                                 .error_estimate = false};
  const auto moment = [&](double restitution) {
    return solve_stationary_density(tests::make_problem({.restitution = restitution}), grid)
        .solution.moments.y2;
  };
  constexpr double kStep = 0.01;
  const auto difference = [&](double h) { return (moment(0.9 + h) - moment(0.9 - h)) / (2 * h); };
  // Richardson extrapolation of the differences
  const double expected = (4 * difference(kStep) - difference(2 * kStep)) / 3;
  const MomentSensitivities s =
      sensitivities(tests::make_problem({.restitution = 0.9}), {"system.restitution"});
  ASSERT_EQ(s.status, Status::ok) << s.reason;
  EXPECT_NEAR(of(s, "E[y^2]").derivatives[0], expected, 1e-3 * expected);
}

// Solution on a coarse grid, with preconditioners of L and of the transposed operator.
struct CoarseSolution {
  explicit CoarseSolution(const problem::Problem& p)
      : problem(problem::to_wall_coordinates(problem::wall_frame(p.system), p)),
        direct(compute_direct_solution(problem, {.scales = problem::motion_scales(problem)},
                                       options, base::Deadline::without_time_limit())) {}

  FiniteVolumeOptions options{.order = 5, .nx = 30, .nv = 64, .x1_max = 4, .x2_max = 4.5};
  problem::Problem problem;
  DirectStationarySolution direct;
  ApproximateLinearSolver solve = [this](Eigen::Ref<Eigen::VectorXd> x) {
    direct.preconditioner->solve_in_place(x);
  };
  ApproximateLinearSolver solve_transposed = [this](Eigen::Ref<Eigen::VectorXd> x) {
    direct.preconditioner->solve_transposed_in_place(x);
  };
  Eigen::VectorXd derivative_of_generator_product(const std::string& key) const {
    return generator_derivative_product(
        problem, options, problem::parameter_difference_quotient(problem, key, 1e-4), direct);
  }
};

// <f, dp> = <h, dL p> for every function f, with the solution h of L* h = -(f - <f, p>).
TEST(DensityDerivative, AgreesWithTheAdjointEquation) {
  constexpr double kTolerance = 1e-12;
  const CoarseSolution coarse(tests::make_problem({.restitution = 0.9}));
  const FokkerPlanckOperator& op = coarse.direct.op;
  const PhasePlaneGrid& grid = coarse.direct.discretisation.grid;
  Eigen::VectorXd f(op.areas.size());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      const double y = grid.x1.cell_centre(i), v = grid.x2.cell_centre(j);
      f(i * grid.v_cell_count() + j) =
          (y * y + 0.5 * v * v + 0.1 * y * v) * op.areas(i * grid.v_cell_count() + j);
    }
  }
  const auto adjoint =
      solve_by_gmres([&](const Eigen::VectorXd& x) { return op.transposed_product(x); },
                     coarse.solve_transposed, f.dot(*coarse.direct.averages) * op.areas - f,
                     op.areas.cwiseInverse(), kTolerance)
          .solution;
  ASSERT_TRUE(adjoint);
  for (const char* key : {"system.damping", "system.restitution", "impulse.rate"}) {
    const Eigen::VectorXd product = coarse.derivative_of_generator_product(key);
    const auto derivative = solve_density_derivative(coarse.direct, product, coarse.solve,
                                                     base::Deadline::without_time_limit())
                                .solution;
    ASSERT_TRUE(derivative);
    const double forward = f.dot(*derivative);
    EXPECT_GT(std::abs(forward), 1e-4) << key;
    EXPECT_NEAR(adjoint->dot(product), forward, 1e-10 * std::max(1.0, std::abs(forward))) << key;
  }
}

TEST(DensityDerivative, IsTheLimitOfDifferencesOfDensitiesOnTheSameGrid) {
  CoarseSolution middle(tests::make_problem({.restitution = 0.9}));
  // Returns the density of a changed problem on the grid of `middle`.
  const auto density = [&](double restitution, double rate) -> Eigen::VectorXd {
    const auto changed = tests::make_problem({.restitution = restitution, .rate = rate});
    const auto op = fokker_planck_operator(
        changed, middle.options,
        discretise_excitation_on_same_grid(changed, middle.options, middle.direct.discretisation));
    return *find_null_vector(op, *middle.direct.preconditioner, *middle.direct.averages,
                             base::Deadline::without_time_limit())
                .averages;
  };
  constexpr double kStep = 1e-3;
  const auto extrapolated = [&](const auto& at) -> Eigen::VectorXd {
    const auto difference = [&](double h) -> Eigen::VectorXd { return (at(h) - at(-h)) / (2 * h); };
    return (4 * difference(kStep) - difference(2 * kStep)) / 3;
  };
  const std::pair<const char*, Eigen::VectorXd> expected[] = {
      {"system.restitution", extrapolated([&](double h) { return density(0.9 + h, 1); })},
      {"impulse.rate", extrapolated([&](double h) { return density(0.9, 1 + h); })}};
  for (const auto& [key, difference] : expected) {
    const auto found =
        solve_density_derivative(middle.direct, middle.derivative_of_generator_product(key),
                                 middle.solve, base::Deadline::without_time_limit())
            .solution;
    ASSERT_TRUE(found);
    EXPECT_NEAR(middle.direct.op.total_mass(*found), 0, 1e-12);
    EXPECT_LT((*found - difference).cwiseAbs().maxCoeff(), 1e-3 * difference.cwiseAbs().maxCoeff())
        << key;
  }
}

// int dp = 0, int y^2 dp = dE[y^2], and the same of y'. In a bin of the width w with the average p
// and the centre y, the integral of y^2 p is (y^2 + w^2/12) w p up to terms whose sum is a multiple
// of int dp = 0.
TEST(MarginalDerivatives, HaveNoMassAndTheDerivativesOfTheMoments) {
  const auto mirrored = [] {
    std::istringstream ini(R"([system]
damping = 0.2
stiffness = 1
cubic = 0.1
[wall]
right = 0.3
right_restitution = 0.9
[impulse]
rate = 1
law = gaussian
intensity = 0.1
)");
    return problem::read_case(ini, "test", "test.ini");
  }();
  const std::pair<problem::Problem, std::vector<double>> problems[] = {
      {tests::make_problem({.damping = 0.2, .restitution = 0.9}), kYEdges},
      {mirrored, uniform_edges(-4.1, 0.3, 110)}};
  for (const auto& [problem, y_edges] : problems) {
    std::vector<problem::ParameterDifferenceQuotient> parameters;
    for (const char* key : {"system.damping", "impulse.intensity"}) {
      parameters.push_back(problem::parameter_difference_quotient(problem, key, 1e-4));
    }
    const MomentSensitivities s =
        solve_sensitivities(problem, {}, parameters, y_edges, kVelocityEdges);
    ASSERT_EQ(s.status, Status::ok) << s.reason;
    ASSERT_EQ(s.marginals.size(), 2u);
    for (std::size_t m = 0; m < 2; ++m) {
      const transform::MarginalDerivatives& marginal = s.marginals[m];
      const auto& moment = of(s, m == 0 ? "E[y^2]" : "E[y'^2]");
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        double mass = 0, second = 0, first = 0;
        for (std::size_t b = 0; b < marginal.derivatives[k].size(); ++b) {
          const double width = marginal.edges[b + 1] - marginal.edges[b],
                       at = marginal.bin_centre(b);
          mass += width * marginal.derivatives[k][b];
          first += width * at * marginal.derivatives[k][b];
          second += width * (at * at + width * width / 12) * marginal.derivatives[k][b];
        }
        // The sum over bins of the slope of dp is its change between the ends.
        const double width = marginal.edges[1] - marginal.edges[0];
        first +=
            width * width / 12 * (marginal.derivatives[k].back() - marginal.derivatives[k].front());
        const double scale = std::abs(moment.derivatives[k]);
        EXPECT_NEAR(mass, 0, 1e-5 * scale) << m << k;
        EXPECT_NEAR(second, moment.derivatives[k], 1e-4 * scale) << m << k;
        if (m == 0) {
          EXPECT_NEAR(first, of(s, "E[y]").derivatives[k], 1e-4 * scale) << k;
        }
        EXPECT_LT(marginal.l1_norm(marginal.errors[k]),
                  0.01 * marginal.l1_norm(marginal.derivatives[k]));
      }
    }
  }
}

// The error estimates on coarse grids are compared with the difference from finer grids.
TEST(MarginalDerivatives, HaveCredibleErrorEstimates) {
  const auto p = tests::make_problem({.damping = 0.2, .restitution = 0.9});
  const MomentSensitivities coarse = sensitivities(p, {"system.restitution"}, {.accuracy = 1}),
                            fine = sensitivities(p, {"system.restitution"}, {.accuracy = 1e-3});
  ASSERT_NE(coarse.details.substr(0, 8), fine.details.substr(0, 8));
  for (std::size_t m = 0; m < 2; ++m) {
    const auto &of_coarse = coarse.marginals[m], &of_fine = fine.marginals[m];
    std::vector<double> difference = of_coarse.derivatives[0];
    for (std::size_t b = 0; b < difference.size(); ++b) difference[b] -= of_fine.derivatives[0][b];
    const double stated = of_coarse.l1_norm(of_coarse.errors[0]);
    EXPECT_LT(of_coarse.l1_norm(difference), 1.5 * stated);
    EXPECT_GT(of_coarse.l1_norm(difference), 0.05 * stated);
    EXPECT_LT(of_fine.l1_norm(of_fine.errors[0]), 0.5 * stated);
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
