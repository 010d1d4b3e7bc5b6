#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "closures.hpp"
#include "epc/closed_form_density.hpp"
#include "epc/form/closed_form_parameters.hpp"
#include "epc/formulations.hpp"
#include "epc/solve.hpp"
#include "general_oscillators.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/case_file.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::epc {
namespace {

using transform::GridDensity;
using transform::Status;

// The time limit lets the tests end on a slow machine (emulation, sanitizers).
ClosureOptions contact_options(int order) {
  ClosureOptions options = tests::closure_options(Formulation::polar, order);
  options.max_seconds = 300;
  return options;
}

problem::Problem bouncing_ball_problem(double rate, double intensity, double restitution) {
  return tests::with_impulses(
      problem::System({.damping = 0, .constant = 1.3, .restitution = restitution}),
      tests::gaussian_impulses(rate, intensity));
}

class RestInContact : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Each, RestInContact, testing::Values(2, 4, 6));

// The basis contains rho^2/2 and v: every order satisfies the balance of power and, up to E[v], the
// balance of momentum. The mass is a sum over cells; the equations use a quadrature rule in
// amplitude and phase.
TEST_P(RestInContact, MeetsItsBalancesAndItsMass) {
  for (const double r : {0.5, 0.7}) {
    const auto p = problem::load_case("preload", {"system.restitution=" + std::to_string(r)});
    const auto [solution, summary] = solve_closure(p, contact_options(GetParam()));
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    EXPECT_LT(summary.residual, 1e-10);
    EXPECT_LT(std::abs(solution.energy_residual), 1e-10);
    EXPECT_NEAR(solution.mass, 1, 3e-6);
    const double drift = 0.1 * solution.moments.v1;  // c E[v]
    EXPECT_NEAR(*summary.balances.momentum, -drift / (0.5 + solution.moments.y1),
                1e-9 + 0.5 * std::abs(drift));
    ASSERT_EQ(solution.atoms.size(), 1u);
    EXPECT_GT(solution.atoms[0].probability, 0.005);
    EXPECT_LT(summary.half_plane->quadrature_change, 1e-5);
  }
}

// The equations for the basis functions rho and v determine the flight time: for rare impulses
// 1 - P0 tends to lambda E|Y| (1 + r) / (g (1 - r)), whatever the rest of the density is.
TEST(RestInContact, UnderRareImpulsesHasTheFlightTimeOfParabolas) {
  for (const double r : {0.5, 0.7}) {
    const auto share = [&](double rate) {
      const auto solution =
          solve_closure(bouncing_ball_problem(rate, rate, r), contact_options(2)).solution;
      if (solution.atoms.empty()) return 0.0;
      const double aloft = rate * std::sqrt(2 / std::numbers::pi) * (1 + r) / (1.3 * (1 - r));
      return (1 - solution.atoms[0].probability) / aloft;
    };
    const double often = share(0.2), rarely = share(0.1);
    EXPECT_LT(often, 0.95 * rarely);
    EXPECT_NEAR(2 * rarely - often, 1, 0.02) << r;
  }
}

TEST(RestInContact, OrdersConvergeTowardsEachOther) {
  const auto p = problem::load_case("preload");
  const double four = *solve_closure(p, contact_options(4)).summary.distance_to_previous;
  const double six = *solve_closure(p, contact_options(6)).summary.distance_to_previous;
  const double eight = *solve_closure(p, contact_options(8)).summary.distance_to_previous;
  EXPECT_LT(six, four / 2);
  EXPECT_LT(eight, six / 2);
}

// The closed form gives the density in physical coordinates, and the cells of the solution contain
// the averages of this density. The second problem has a right wall at 0.3.
TEST(RestInContact, IsEvaluatedFromItsClosedForm) {
  const auto impulses = tests::gaussian_impulses(1, 0.5);
  const problem::Problem problems[] = {
      problem::load_case("preload"),
      tests::with_impulses(problem::System({.damping = 0.1, .constant = -0.8, .stiffness = 1},
                                           {.right = 0.3, .right_restitution = 0.7}),
                           impulses)};
  for (const auto& physical : problems) {
    const auto seen = tests::in_wall_coordinates(physical);
    ClosureResult result = solve_closure(seen, contact_options(4));
    ASSERT_EQ(result.solution.status, Status::ok) << result.solution.reason;
    const auto form = read_closed_form(result.solution.metrics);
    EXPECT_EQ(form.frame.variables, ExponentCoordinates::contact);
    EXPECT_TRUE(can_be_normalised(form));
    const auto again = density_of_closed_form(form, &physical);
    const auto solution =
        transform::to_physical_coordinates(seen.frame, std::move(result.solution));
    const auto& cells = std::get<GridDensity>(*solution.density);
    double most = 0;
    for (std::size_t i = 60; i < cells.y_cell_count(); i += 25) {
      for (std::size_t j = 5; j < cells.v_cell_count(); j += 31) {
        const double average = cells.cell_average(i, j);
        const double evaluated_average = numerics::gauss_legendre_average(
            [&](double y) {
              return numerics::gauss_legendre_average([&](double v) { return again.value(y, v); },
                                                      cells.v_edges[j], cells.v_edges[j + 1]);
            },
            cells.y_edges[i], cells.y_edges[i + 1]);
        EXPECT_NEAR(evaluated_average, average, 1e-6 * average) << i << ' ' << j;
        most = std::max(most, average);
      }
    }
    EXPECT_GT(most, 0.1);
    EXPECT_NEAR(solution.atoms[0].y, physical.system.left_wall() ? 0 : 0.3, 1e-15);
    // Without its constant the form is normalised again, including the atom.
    auto without = form;
    without.frame.log_constant.reset();
    EXPECT_NEAR(density_of_closed_form(without, &physical).value(0.2, 0.1) / again.value(0.2, 0.1),
                1, 1e-5);
  }
}

}  // namespace
}  // namespace fpkcheck::epc
