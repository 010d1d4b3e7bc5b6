// Observed orders of the scheme, with lower and upper limits, on three grids each: against exact
// solutions, against a manufactured density that an impact with losses maps onto itself, and by
// self-convergence.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "distances.hpp"
#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "fd_fpk/linear/null_vector_and_eigenvalues.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Cell averages of a function, by five Gauss points in each direction.
template <class Function>
Eigen::VectorXd cell_averages(const PhasePlaneGrid& grid, const Function& f) {
  using Rule = boost::math::quadrature::gauss<double, 5>;
  Eigen::VectorXd averages(grid.size());
  for (int i = 0; i < grid.nx(); ++i) {
    for (int j = 0; j < grid.v_cell_count(); ++j) {
      averages(i * grid.v_cell_count() + j) =
          Rule::integrate(
              [&](double x) {
                return Rule::integrate([&](double v) { return f(x, v); }, grid.x2.face_position(j),
                                       grid.x2.face_position(j + 1));
              },
              grid.x1.face_position(i), grid.x1.face_position(i + 1)) /
          (grid.x1.cell_width(i) * grid.x2.cell_width(j));
    }
  }
  return averages;
}

double l1(const PhasePlaneGrid& grid, const Eigen::VectorXd& averages) {
  return grid.cell_areas().dot(averages.cwiseAbs());
}

// Checks the observed order of convergence of three errors; the cell width decreases by the same
// factor from each error to the next.
void expect_order(double coarse, double middle, double fine, double factor, double least,
                  double most) {
  for (const double observed :
       {std::log(coarse / middle) / std::log(factor), std::log(middle / fine) / std::log(factor)}) {
    EXPECT_GT(observed, least) << coarse << " " << middle << " " << fine;
    EXPECT_LT(observed, most) << coarse << " " << middle << " " << fine;
  }
}

// The null vector on a grid.
struct Solved {
  PhasePlaneGrid grid;
  Eigen::VectorXd averages;
};
Solved stationary(const problem::Problem& p, DensityEquation equation, int order, int nx, int nv,
                  double x1_max, double x2_max) {
  PhasePlaneGrid grid = make_grid(nx, nv, x1_max, x2_max);
  const DiscretisedExcitation excitation = equation == DensityEquation::kf
                                               ? jump_excitation(p.impulses, grid.x2)
                                               : white_noise_excitation(p.impulses);
  const auto op = fokker_planck_operator(p.system, excitation, ImpactCondition::map, grid, order);
  Preconditioner preconditioner(p, excitation, ImpactCondition::map, grid);
  auto solution =
      find_null_vector(op, preconditioner, initial_gaussian(grid, problem::motion_scales(p)));
  EXPECT_TRUE(solution.averages.has_value()) << solution.failure;
  return {std::move(grid), *solution.averages};
}

class ObservedOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Convergence, ObservedOrder, testing::Values(3, 5, 7),
                         [](const auto& of) { return "Order" + std::to_string(of.param); });

TEST_P(ObservedOrder, JointDensityUnderWhiteNoiseHasTheOrderOfTheScheme) {
  const int order = GetParam();
  const auto p = tests::make_problem({.restitution = 1});
  const exact::WhiteNoiseDensity exact(p);
  const auto error = [&](int nx) {
    const auto [grid, averages] =
        stationary(p, DensityEquation::white, order, nx, 2 * nx, 4.6, 5.0);
    return l1(grid,
              averages - cell_averages(grid, [&](double x, double v) { return 2 * exact(x, v); }));
  };
  expect_order(error(20), error(30), error(45), 1.5, order - 0.6, order + 1.2);
}

TEST_P(ObservedOrder, MarginalsAndJointDensityUnderJumpsHaveTheOrderOfTheScheme) {
  const int order = GetParam();
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  static const exact::LinearDensity exact(p);
  struct Errors {
    double joint, y, v;
  };
  const auto errors = [&](int nx) {
    const auto [grid, averages] = stationary(p, DensityEquation::kf, order, nx, 2 * nx, 5.4, 5.6);
    const auto joint = exact.joint_averages(grid.x1.faces(), grid.x2.faces());
    const auto y = exact.displacement_averages(grid.x1.faces());
    const auto v = exact.velocity_averages(grid.x2.faces());
    const auto [of_y, of_v] = marginals(grid, averages);
    const auto as_vector = [](const std::vector<double>& values) {
      return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
    };
    return Errors{l1(grid, averages - as_vector(joint)),
                  grid.x1.cell_widths().dot((of_y - as_vector(y)).cwiseAbs()),
                  grid.x2.cell_widths().dot((of_v - as_vector(v)).cwiseAbs())};
  };
  const int first = order < 7 ? 24 : 36;  // the seventh order is observed on finer grids only
  const auto coarse = errors(first), middle = errors(first * 3 / 2), fine = errors(first * 9 / 4);
  expect_order(coarse.joint, middle.joint, fine.joint, 1.5, order - 0.6, order + 1.4);
  expect_order(coarse.y, middle.y, fine.y, 1.5, order - 0.6, order + 1.6);
  expect_order(coarse.v, middle.v, fine.v, 1.5, order - 0.6, order + 1.6);
}

TEST(ImpulseLaws, EachGivesTheExactMarginalsOfTheLinearOscillator) {
  for (const auto* law : {"gaussian", "laplace", "uniform", "two_point"}) {
    SCOPED_TRACE(law);
    const auto p = tests::make_problem({.cubic = 0, .restitution = 1, .law = law});
    const exact::LinearDensity exact(p, 1e-11);
    const auto solution =
        solve_stationary_density(p, {.stepper = StationarySolver::direct, .error_estimate = false})
            .solution;
    ASSERT_EQ(solution.status, transform::Status::ok) << solution.reason;
    const auto [y, v] = tests::distances(
        solution, [&](const auto& edges) { return exact.displacement_averages(edges); },
        [&](const auto& edges) { return exact.velocity_averages(edges); });
    EXPECT_LT(y, 1e-4);
    EXPECT_LT(v, 1e-4);
  }
}

// p = exp(-x^2) P(v), with P = v^6 exp(-v^2) for v < 0 and (v/r)^6 exp(-(v/r)^2) / r^2 for v > 0.
// This density satisfies the impact condition p(0, w) = p(0, -w/r) / r^2. P has five derivatives at
// 0.
struct Manufactured {
  const problem::System& system;
  double d2;

  double scale(double v) const { return v < 0 ? 1 : 1 / system.restitution(); }
  double density(double x, double v) const {
    const double s = scale(v), u = s * v;
    return std::exp(-x * x) * s * s * std::pow(u, 6) * std::exp(-u * u);
  }
  // L p = -v p_x + [(c v + g(x)) p]_v + D2 p_vv
  double rate(double x, double v) const {
    const double s = scale(v), u = s * v, e = std::exp(-x * x) * s * s * std::exp(-u * u);
    const double p = std::pow(u, 6) * e;
    const double p_v = s * (6 * std::pow(u, 5) - 2 * std::pow(u, 7)) * e;
    const double p_vv =
        s * s * (30 * std::pow(u, 4) - 26 * std::pow(u, 6) + 4 * std::pow(u, 8)) * e;
    return 2 * x * v * p + system.damping() * p +
           (system.damping() * v + system.restoring_force()(x)) * p_v + d2 * p_vv;
  }
};

TEST_P(ObservedOrder, AManufacturedDensityWithLossesHasTheOrderOfTheScheme) {
  const int order = GetParam();
  for (const double r : {0.8, 0.5}) {
    const auto p = tests::make_problem({.cubic = 0.3, .restitution = r, .intensity = 0.5});
    const Manufactured exact{p.system, p.impulses.intensity() / 2};
    const auto error = [&](int nx) {
      const PhasePlaneGrid grid = make_grid(nx, 4 * nx, 5.0, 5.5);
      const DiscretisedExcitation excitation = white_noise_excitation(p.impulses);
      const auto op =
          fokker_planck_operator(p.system, excitation, ImpactCondition::map, grid, order);
      const Eigen::VectorXd density =
          cell_averages(grid, [&](double x, double v) { return exact.density(x, v); });
      Eigen::VectorXd source =
          cell_averages(grid, [&](double x, double v) { return exact.rate(x, v); });
      // L q = source is solvable for a source of mass 0; the mass of this source is 0 except for
      // the truncation by the box.
      Eigen::VectorXd defect = source - op * density;
      defect.array() -= op.total_mass(defect) / op.areas.sum();
      Preconditioner preconditioner(p, excitation, ImpactCondition::map, grid);
      EXPECT_TRUE(preconditioner.factorise_stationary());
      const auto correction =
          solve_by_gmres([&](const Eigen::VectorXd& q) { return op * q; },
                         [&](Eigen::Ref<Eigen::VectorXd> b) { preconditioner.solve_in_place(b); },
                         defect, op.areas, 1e-9)
              .solution;
      EXPECT_TRUE(correction.has_value());
      return l1(grid, *correction) / l1(grid, density);
    };
    SCOPED_TRACE(r);
    const int first = order < 7 ? 24 : 34;
    expect_order(error(first), error(first * 17 / 12), error(first * 2), std::sqrt(2.0),
                 order - 0.8, order + 1.4);
  }
}

// Without an exact solution: differences of moments on grids refined by sqrt(2).
TEST(SelfConvergence, ThePapersCasesHaveOrderFiveOnGradedGrids) {
  for (const double r : {0.98, 0.7}) {
    for (const int number : {1, 2, 4}) {  // case 3 equals case 2 in other units
      if (number != (r > 0.9 ? 1 : 4) && !tests::is_thorough()) continue;
      auto p = tests::paper_case(number);
      auto coefficients = p.system.coefficients();
      coefficients.restitution = r;
      p.system = problem::System(coefficients);
      const auto moments_at = [&](double refinement) {
        return solve_stationary_density(
                   p, {.stepper = StationarySolver::direct,
                       .refinement = refinement,
                       .origin_refinement = 16,
                       .x1_max = 6.2 * std::sqrt(0.45 * p.impulses.intensity() / 0.1 /
                                                 (1 + 10 * (1 - r) + (number == 4 ? 3 : 0))),
                       .x2_max = 7.5 * std::sqrt(0.45 * p.impulses.intensity() / 0.1),
                       .error_estimate = false})
            .solution.moments;
      };
      const auto a = moments_at(0.8), b = moments_at(0.8 * std::sqrt(2.0)), c = moments_at(1.6);
      const auto difference = [](const auto& m, const auto& n) {
        return std::abs(m.y2 / n.y2 - 1) + std::abs(m.v2 / n.v2 - 1);
      };
      const double observed = 2 * std::log2(difference(a, b) / difference(b, c));
      EXPECT_GT(observed, 4.2) << number << " " << r;
      EXPECT_LT(observed, 6.5) << number << " " << r;
    }
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
