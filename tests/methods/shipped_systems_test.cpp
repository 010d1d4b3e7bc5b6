#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/rest_atoms.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/case_file.hpp"

// Each shipped system (docs/systems.md): finite volumes against the exact law where one is known,
// else against the simulation, which shares only the problem with them.
namespace fpkcheck::methods {
namespace {

using transform::Solution;
using transform::StateVariable;

Solution solved(const problem::Problem& problem, const std::string& id,
                const base::Values& options = {}) {
  const auto registry = builtin_registry();
  const auto method = registry.methods_selected_by_list(id, options).front();
  return solve_with_method(method, problem, {compare::comparison_bins(problem), {}});
}

class ExactSystems : public testing::TestWithParam<const char*> {};

TEST_P(ExactSystems, AreSolvedByFiniteVolumes) {
  const auto problem = problem::load_case(GetParam());
  const Solution solution = solved(problem, "fd-kf");
  ASSERT_TRUE(solution.has_status_ok()) << solution.reason;
  const exact::EnergyLaw law(problem);
  const auto axes = compare::comparison_bins(problem);
  for (const auto variable : transform::kVariables) {
    const auto marginal =
        transform::marginal(solution, variable, comparison_bin_edges(axes, variable));
    double l1 = 0;
    for (std::size_t k = 0; k < marginal.size(); ++k) {
      const double exact = numerics::gauss_legendre_average(
          [&](double x) {
            return variable == StateVariable::y ? law.displacement_marginal(x)
                                                : law.velocity_marginal(x);
          },
          marginal.edges[k], marginal.edges[k + 1]);
      l1 += std::abs(marginal.density[k] - exact) * marginal.bin_width(k);
    }
    EXPECT_LT(l1, 1e-4) << transform::name(variable);
  }
  EXPECT_NEAR(solution.moments.y2, law.moment(2, 0), 1e-4 * law.moment(2, 0));
  EXPECT_NEAR(solution.moments.v2, law.moment(0, 2), 1e-4 * law.moment(0, 2));
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExactSystems,
                         testing::Values("duffing", "bistable", "ring", "ball_white"),
                         [](const auto& system) { return std::string(system.param); });

TEST(LinearSystem, HasItsCumulants) {
  const auto problem = problem::load_case("linear");
  const Solution solution = solved(problem, "fd-kf");
  ASSERT_TRUE(solution.has_status_ok()) << solution.reason;
  const auto kappa = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
  const auto& m = solution.moments;
  EXPECT_NEAR(m.y1 / kappa(1, 0), 1, 1e-6);
  EXPECT_NEAR((m.y2 - m.y1 * m.y1) / kappa(2, 0), 1, 1e-6);
  EXPECT_NEAR(m.v2 / kappa(0, 2), 1, 1e-6);
  EXPECT_NEAR((m.v4 - 3 * m.v2 * m.v2) / kappa(0, 4), 1, 1e-6);
}

// Shipped cases of formulas. The softening spring has p ~ exp(-(c/D)(v^2/2 + V)) with D/c = 0.5,
// the double well of Duffing the same with D/c = 0.25, and p of caughey_ma depends on the energy.
TEST(Formulas, ShippedCasesHaveTheirExactMoments) {
  const auto mean_square = [](const auto& potential, double temperature) {
    double mass = 0, square = 0;
    for (double y = -10; y < 10; y += 1e-3) {  // the trapezoidal rule: the densities vanish at 10
      const double density = std::exp(-potential(y) / temperature);
      mass += density;
      square += y * y * density;
    }
    return square / mass;
  };
  const auto softening = [](double y) { return std::log(std::cosh(y)) + 0.025 * y * y; };
  const auto wells = [](double y) { return std::pow(y, 4) / 4 - y * y / 2; };
  struct {
    const char* name;
    double y2, v2;
  } const cases[] = {{"softening", mean_square(softening, 0.5), 0.5},
                     {"multiplicative_duffing", mean_square(wells, 0.25), 0.25},
                     {"caughey_ma", 0.6, 0.6}};
  for (const auto& [name, y2, v2] : cases) {
    const Solution solution = solved(problem::load_case(name), "fd-kf", {{"max_seconds", 200.0}});
    ASSERT_TRUE(solution.has_status_ok()) << name << solution.reason;
    EXPECT_NEAR(solution.moments.y2, y2, 2 * solution.error->moments.y2 + 1e-9) << name;
    EXPECT_NEAR(solution.moments.v2, v2, 2 * solution.error->moments.v2 + 1e-9) << name;
    EXPECT_LT(solution.error->moments.y2, 1e-5) << name;
  }
}

class OtherSystems : public testing::TestWithParam<const char*> {};

// The sampling error in L1 varies by some tens of per cent.
TEST_P(OtherSystems, AgreeBetweenFiniteVolumesAndSimulation) {
  const auto problem = problem::load_case(GetParam());
  // A loaded machine needs more than the default time.
  const Solution differences = solved(problem, "fd-kf", {{"max_seconds", 200.0}});
  ASSERT_TRUE(differences.has_status_ok()) << differences.reason;
  const Solution simulated = solved(problem, "mcs", {{"seed", std::int64_t{7}}, {"time", 4e5}});
  ASSERT_TRUE(simulated.has_status_ok()) << simulated.reason;
  const auto axes = compare::comparison_bins(problem);
  for (const auto variable : transform::kVariables) {
    const auto& bins = comparison_bin_edges(axes, variable);
    const double l1 = transform::l1_distance(transform::marginal(differences, variable, bins),
                                             transform::marginal(simulated, variable, bins)) +
                      compare::rest_atom_l1_distance(differences.atoms, simulated.atoms, variable);
    EXPECT_LT(l1, 1.6 * transform::expected_l1_error(*simulated.sampling, variable).value() +
                      transform::l1_error_of_marginal(*differences.error, variable))
        << transform::name(variable);
  }
  EXPECT_NEAR(differences.moments.v2, simulated.moments.v2,
              4 * simulated.standard_errors->moments.v2 + 1e-4 * simulated.moments.v2);
}

INSTANTIATE_TEST_SUITE_P(Shipped, OtherSystems,
                         testing::Values("tilted", "van_der_pol", "gap", "two_walls", "box",
                                         "preload", "ball", "stops"),
                         [](const auto& system) { return std::string(system.param); });

}  // namespace
}  // namespace fpkcheck::methods
