#include "fd_fpk/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using tests::uniform_edges;
using transform::StateVariable;
using transform::Status;

// A single grid: error estimates have their own tests.
FiniteVolumeOptions direct(DensityEquation equation) {
  return {.equation = equation, .stepper = StationarySolver::direct, .error_estimate = false};
}

TEST(Solve, WhiteNoiseConvergesToTheExactMarginalsWithOrderFive) {
  const auto p = tests::make_problem({.restitution = 1});
  const exact::WhiteNoiseDensity exact(p);
  const auto y_edges = uniform_edges(0, 4, 50), v_edges = uniform_edges(-4, 4, 80);
  const auto error = [&](int cells) {
    FiniteVolumeOptions options = direct(DensityEquation::white);
    options.nx = cells;
    options.nv = 2 * cells;
    options.x1_max = 4.6;
    options.x2_max = 5.0;
    const auto solution = solve_stationary_density(p, options).solution;
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    double sum = 0;
    for (const auto variable : {StateVariable::y, StateVariable::ydot}) {
      const auto& edges = variable == StateVariable::y ? y_edges : v_edges;
      const auto m = marginal(solution, variable, edges);
      for (std::size_t b = 0; b < m.size(); ++b) {
        // Average of the exact density over the bin, by Simpson's rule.
        const auto density = [&](double x) {
          return variable == StateVariable::y ? exact.displacement_marginal(x)
                                              : exact.velocity_marginal(x);
        };
        const double average =
            (density(edges[b]) + 4 * density(m.bin_centre(b)) + density(edges[b + 1])) / 6;
        sum += std::abs(m.density[b] - average) * m.bin_width(b);
      }
    }
    return sum;
  };
  const double coarse = error(24), middle = error(34), fine = error(48);
  const double ratio = std::log(std::sqrt(2.0));
  for (const double observed :
       {std::log(coarse / middle) / ratio, std::log(middle / fine) / ratio}) {
    EXPECT_GT(observed, 4.5) << coarse << " " << middle << " " << fine;
    EXPECT_LT(observed, 6.5) << coarse << " " << middle << " " << fine;
  }
  EXPECT_LT(fine, 4e-5);
}

TEST(Solve, StatesIdentityErrorsAndMetrics) {
  const auto p = tests::paper_case(1);
  FiniteVolumeOptions options{.equation = DensityEquation::km4,
                              .impact = ImpactCondition::delta,
                              .stepper = StationarySolver::direct,
                              .error_estimate = false};
  const auto plain = solve_stationary_density(p, options);
  EXPECT_EQ(plain.solution.identity, solution_identity(options));
  EXPECT_EQ(plain.solution.metrics, solver_metrics(plain.summary));
  EXPECT_FALSE(plain.solution.error);
  options.error_estimate = true;
  const auto [solution, summary] = solve_stationary_density(p, options);
  EXPECT_EQ(solution.identity, solution_identity(options));
  EXPECT_EQ(solution.metrics, solver_metrics(summary));
  ASSERT_TRUE(solution.error && summary.error);
  EXPECT_EQ(solution.error->y_l1, summary.error->y_l1);
  EXPECT_EQ(solution.error->ydot_l1, summary.error->ydot_l1);
  EXPECT_EQ(solution.error->moments.v4, summary.error->moments.v4);
  EXPECT_GT(solution.error->moments.v4, 0);
}

TEST(Solve, StatesIdentityAndMetricsWithoutADensity) {
  const FiniteVolumeOptions literal{.equation = DensityEquation::km4, .regularisation_length = 0};
  const auto [solution, summary] = solve_stationary_density(tests::paper_case(1), literal);
  EXPECT_EQ(solution.id(), "fd-km4");
  EXPECT_EQ(solution.metrics, solver_metrics(summary));
  EXPECT_GT(*metric_number(solution.metrics, "growth_rate"), 1.0);
}

TEST(Solve, JumpsReproduceTheExactCumulantsOfTheLinearOscillator) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  const auto solution = solve_stationary_density(p, direct(DensityEquation::kf)).solution;
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  const auto fourth = [&](double k4, double k2) { return k4 + 3 * k2 * k2; };
  const double x2 = exact::linear_cumulant(p, 2, 0);
  const double v2 = exact::linear_cumulant(p, 0, 2);
  EXPECT_NEAR(solution.moments.y2, x2, 3e-5);
  EXPECT_NEAR(solution.moments.v2, v2, 3e-5);
  EXPECT_NEAR(solution.moments.y4, fourth(exact::linear_cumulant(p, 4, 0), x2), 2e-4);
  EXPECT_NEAR(solution.moments.v4, fourth(exact::linear_cumulant(p, 0, 4), v2), 2e-4);
}

TEST(Solve, JumpsReproduceTheNonlinearElasticTable) {
  struct Row {
    double intensity, cubic, rate;
    int nx, nv;
    double y2, y4, v4, y4_error, v4_error;
  };
  for (const Row& row : {Row{.1, .1, 1, 36, 84, .44181, .58190, .8078, 2e-4, 3e-4},
                         Row{.1, 1, 1, 50, 112, .28632, .21368, .8107, 1e-4, 3e-4},
                         Row{1, 1, 1, 50, 112, 1.2564, 3.743, 81.3, 2e-3, .1},
                         Row{.1, .1, 10, 36, 100, .44410, .55904, .7558, 2e-4, 3e-4}}) {
    const auto p = tests::make_problem(
        {.cubic = row.cubic, .restitution = 1, .rate = row.rate, .intensity = row.intensity});
    FiniteVolumeOptions options = direct(DensityEquation::kf);
    options.nx = row.nx;
    options.nv = row.nv;
    const auto solution = solve_stationary_density(p, options).solution;
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_NEAR(solution.moments.y2, row.y2, 5e-5 * row.y2);
    EXPECT_NEAR(solution.moments.y4, row.y4, row.y4_error);
    EXPECT_NEAR(solution.moments.v4, row.v4, row.v4_error);
    EXPECT_NEAR(solution.moments.v2, exact::mean_square_velocity(p), 1e-4 * row.intensity * 5);
  }
}

TEST(Solve, SteppingMeetsTheLimitsOfMassEnergyAndStationarityForThePapersCases) {
  for (const int number : {1, 4}) {
    for (const auto equation :
         {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
      // The time limit is generous, because the solver skips time steps if time is short, and the
      // machine may be slow.
      const auto [solution, summary] = solve_stationary_density(
          tests::paper_case(number),
          {.equation = equation, .error_estimate = false, .max_seconds = 600});
      ASSERT_EQ(solution.status, Status::ok) << solution.reason;
      EXPECT_NEAR(solution.mass, 1.0, 1e-10);
      EXPECT_LT(std::abs(solution.energy_residual), 1e-4) << name(equation) << " " << number;
      EXPECT_LT(summary.residual, 1e-8);
      EXPECT_LT(summary.stepped_against_direct, 1e-7);
      EXPECT_LT(summary.leak, 1e-10);
      EXPECT_LE(summary.factorisations, 20);
      EXPECT_GT(summary.steps, 1);
      EXPECT_GT(solution.min_density, -1e-5);
    }
  }
}

TEST(Solve, CasesTwoAndThreeAreOneProblem) {
  // p_3(y) = a p_2(a y) with a = sqrt(10); likewise for y'.
  const double a = std::sqrt(10.0);
  const auto two =
      solve_stationary_density(tests::paper_case(2), direct(DensityEquation::kf)).solution;
  const auto three =
      solve_stationary_density(tests::paper_case(3), direct(DensityEquation::kf)).solution;
  for (const auto variable : {StateVariable::y, StateVariable::ydot}) {
    const auto edges =
        variable == StateVariable::y ? uniform_edges(0, 2, 40) : uniform_edges(-2, 2, 80);
    auto scaled_edges = edges;
    for (double& e : scaled_edges) e *= a;
    const auto p3 = marginal(three, variable, edges), p2 = marginal(two, variable, scaled_edges);
    for (std::size_t b = 0; b < p3.size(); ++b) EXPECT_NEAR(p3.density[b], a * p2.density[b], 1e-8);
  }
  EXPECT_NEAR(three.moments.y4 * 100, two.moments.y4, 1e-7 * two.moments.y4);
}

TEST(Solve, TruncationErrorIsSmallAndWhiteNoiseErrorLarge) {
  const auto p = tests::paper_case(1);
  const auto kf = solve_stationary_density(p, direct(DensityEquation::kf)).solution;
  const auto km4 = solve_stationary_density(p, direct(DensityEquation::km4)).solution;
  const auto white = solve_stationary_density(p, direct(DensityEquation::white)).solution;
  const auto edges = uniform_edges(-4.5, 4.5, 120);
  const auto reference = marginal(kf, StateVariable::ydot, edges);
  EXPECT_LT(l1_distance(marginal(km4, StateVariable::ydot, edges), reference), 1.5e-3);
  EXPECT_GT(l1_distance(marginal(white, StateVariable::ydot, edges), reference), 2e-2);
}

TEST(Solve, LiteralTruncationOnAFineGridIsIllPosedAndNotSolved) {
  const auto [solution, summary] = solve_stationary_density(
      tests::paper_case(1), {.equation = DensityEquation::km4, .regularisation_length = 0});
  EXPECT_EQ(solution.status, Status::ill_posed);
  EXPECT_FALSE(solution.density.has_value());
  EXPECT_GT(summary.growth_rate, 1.0);
  EXPECT_EQ(summary.steps, 0);
  EXPECT_NE(solution.reason.find("least 0.23 "), std::string::npos)
      << solution.reason;  // the required length
  // The default length.
  EXPECT_NE(solution.reason.find("0.316"), std::string::npos) << solution.reason;
}

TEST(Solve, NonzeroMeanImpulsesKeepTheEnergyBalanceInEveryEquation) {
  const auto p = tests::make_problem({.restitution = 0.9, .mean = 0.1});
  for (const auto equation : {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
    const auto solution = solve_stationary_density(p, direct(equation)).solution;
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_LT(std::abs(solution.energy_residual), 3e-4);
    EXPECT_NEAR(solution.moments.v1, 0.0, 5e-5);  // dE[y]/dt = E[y'] = 0
  }
}

// For any equation, law and impact: problem/balances.hpp. A wrong sign of the mean or factor
// of the impact would leave a residual of a few per cent or more.
TEST(Solve, KeepsTheBalancesOfVirialAndMomentumInEveryEquationAndImpact) {
  for (const double mean : {0.1, -0.1}) {
    const auto p = tests::make_problem({.restitution = 0.9, .mean = mean});
    for (const auto impact : {ImpactCondition::map, ImpactCondition::delta}) {
      if ((mean > 0) != (impact == ImpactCondition::map) && !tests::is_thorough()) continue;
      for (const auto equation :
           {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
        SCOPED_TRACE(std::string(name(equation)) + "/" + std::string(name(impact)));
        FiniteVolumeOptions options = direct(equation);
        options.impact = impact;
        const auto [solution, summary] = solve_stationary_density(p, options);
        ASSERT_TRUE(solution.density.has_value()) << solution.reason;
        EXPECT_LT(std::abs(*summary.balances.virial), 5e-5);
        EXPECT_LT(std::abs(*summary.balances.momentum), 5e-5);
        EXPECT_EQ(transform::metric_number(solution.metrics, "balances.virial"),
                  summary.balances.virial);
      }
    }
  }
}

TEST(Solve, WidensItsBoxForHeavyTails) {
  const auto [solution, summary] =
      solve_stationary_density(tests::make_problem({.rate = 0.3}), direct(DensityEquation::kf));
  ASSERT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_GT(summary.x2_max, 7.5 * std::sqrt(solution.moments.v2));
  EXPECT_LT(summary.wall.x2, 1e-5);
}

// Under heavy damping rare impulses cause a spike at the wall that no uniform grid of this size
// resolves.
TEST(Solve, AnUnresolvedDensityIsInadmissible) {
  for (const auto& p :
       {tests::make_problem({.damping = 3, .cubic = 0}), tests::make_problem({.rate = 0.02})}) {
    FiniteVolumeOptions free = direct(DensityEquation::kf);
    free.error_estimate = true;
    FiniteVolumeOptions upwind = free;
    upwind.transport = TransportScheme::upwind;
    upwind.refine_unresolved = false;
    const auto unresolved = solve_stationary_density(p, upwind).solution;
    EXPECT_EQ(unresolved.status, Status::inadmissible) << unresolved.min_density;
    EXPECT_NE(unresolved.reason.find("refine"), std::string::npos) << unresolved.reason;
    const auto [solution, summary] = solve_stationary_density(p, free);
    EXPECT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_EQ(summary.transport, TransportScheme::characteristics);
  }
}

TEST(Solve, DoesNotDependOnTheUnitOfTime) {
  const FiniteVolumeOptions white{.equation = DensityEquation::white, .error_estimate = false};
  const auto reference = solve_stationary_density(tests::paper_case(1), white);
  for (const double t : {1e8, 1e-6}) {
    // y(t/T): c/T, k/T^2, mu/T^2, lambda/T, lambda E[Y^2]/T^3; velocities scale with 1/T.
    const auto p = tests::make_problem({.damping = 0.1 / t,
                                        .stiffness = 1 / (t * t),
                                        .cubic = 0.1 / (t * t),
                                        .rate = 1 / t,
                                        .intensity = 0.1 / (t * t * t)});
    const auto scaled = solve_stationary_density(p, white);
    ASSERT_EQ(scaled.solution.status, Status::ok) << scaled.solution.reason;
    EXPECT_EQ(scaled.summary.steps, reference.summary.steps);
    EXPECT_NEAR(scaled.solution.moments.y4, reference.solution.moments.y4, 1e-8);
    EXPECT_NEAR(scaled.solution.moments.v2 * t * t, reference.solution.moments.v2, 1e-8);
  }
}

// At a given intensity the effect of frequent impulses beyond white noise is their fourth cumulant,
// proportional to 1 / rate; also on cells 300 times as wide as an impulse.
TEST(Solve, FrequentImpulsesTendToWhiteNoiseByTheirFourthCumulant) {
  const auto problem = [](double rate, double cubic) {
    return tests::make_problem({.cubic = cubic, .restitution = 1, .rate = rate});
  };
  const auto of = [&](double rate, double cubic, DensityEquation equation) {
    return solve_stationary_density(problem(rate, cubic), direct(equation)).solution.moments;
  };
  const auto linear = of(1e4, 0, DensityEquation::white);
  for (const double rate : {1e3, 1e4, 1e5}) {
    const double cumulant = exact::linear_cumulant(problem(rate, 0), 0, 4);
    EXPECT_NEAR((of(rate, 0, DensityEquation::kf).v4 - linear.v4) / cumulant, 1, 1e-2) << rate;
  }
  const double white = of(1e4, 0.1, DensityEquation::white).y2;
  const double at_1e3 = of(1e3, 0.1, DensityEquation::kf).y2 - white,
               at_1e4 = of(1e4, 0.1, DensityEquation::kf).y2 - white;
  EXPECT_NEAR(at_1e3 / at_1e4, 10, 0.1);
}

// With losses at the impact, the grid for separate impulses would cause an error of 1.5e-4 in this
// test.
TEST(Solve, FrequentImpulsesHaveTheGridOfWhiteNoise) {
  const auto p = [](double rate) {
    return tests::make_problem({.restitution = 0.5, .rate = rate});
  };
  const auto white = solve_stationary_density(p(1), direct(DensityEquation::white));
  const auto kf = solve_stationary_density(p(1e8), direct(DensityEquation::kf));
  ASSERT_EQ(kf.solution.status, Status::ok) << kf.solution.reason;
  EXPECT_EQ(kf.summary.nx, white.summary.nx);
  EXPECT_NEAR(kf.solution.moments.y2, white.solution.moments.y2, 1e-7);
}

TEST(Solve, RefusesGridsThatAreTooLargeOrTooCoarse) {
  FiniteVolumeOptions many = direct(DensityEquation::kf);
  many.refinement = 10;
  const auto huge = solve_stationary_density(tests::paper_case(1), many).solution;
  EXPECT_EQ(huge.status, Status::failed);
  EXPECT_NE(huge.reason.find("cells"), std::string::npos) << huge.reason;

  FiniteVolumeOptions long_step{.equation = DensityEquation::km4,
                                .stepper = StationarySolver::direct};
  long_step.regularisation_length = 1e10;
  EXPECT_EQ(solve_stationary_density(tests::paper_case(1), long_step).solution.status,
            Status::failed);
}

TEST(Solve, ReportsABoxThatIsTooSmall) {
  FiniteVolumeOptions options = direct(DensityEquation::kf);
  options.x1_max = 1.0;
  options.x2_max = 1.2;
  const auto solution = solve_stationary_density(tests::paper_case(1), options).solution;
  EXPECT_EQ(solution.status, Status::failed);
  EXPECT_NE(solution.reason.find("box"), std::string::npos);
}

TEST(Solve, ReportsAResidualAboveItsThreshold) {
  for (const auto stepper : {StationarySolver::cvode, StationarySolver::direct}) {
    const auto solution =
        solve_stationary_density(tests::paper_case(1), {.equation = DensityEquation::white,
                                                        .stepper = stepper,
                                                        .nx = 20,
                                                        .nv = 40,
                                                        .error_estimate = false,
                                                        .residual_tolerance = 1e-30})
            .solution;
    EXPECT_EQ(solution.status, Status::not_converged);
    EXPECT_NE(solution.reason.find("1.0e-30"), std::string::npos) << solution.reason;
  }
}

TEST(Solve, RefusesInvalidOptions) {
  EXPECT_THROW(solve_stationary_density(tests::paper_case(1), {.order = 9}), InputError);
  EXPECT_THROW(solve_stationary_density(tests::paper_case(1), {.regularisation_length = 0.3}),
               InputError);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
