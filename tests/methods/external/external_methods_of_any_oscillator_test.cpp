#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/external/external_density.hpp"
#include "methods/external/external_marginal.hpp"
#include "methods/external/external_methods.hpp"
#include "methods/external/external_samples.hpp"
#include "methods/external/joint_table.hpp"
#include "methods/external/range_between_walls.hpp"
#include "methods/run_cases.hpp"
#include "refusal.hpp"
#include "results/joint_netcdf.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

// External densities of oscillators other than the paper's. Without impact losses their laws are
// known exactly.
namespace fpkcheck::methods {
namespace {

using problem::DensityEquation;
using problem::Problem;
using problem::System;
using problem::Wall;
using problem::WallParameters;
using problem::Walls;
using tests::contains;
using transform::StateVariable;
using transform::Status;

Problem bistable() {
  return tests::with_noise(System({.damping = 0.2, .stiffness = -1, .cubic = 1}, {.none = true}),
                           0.1);
}
// A system with a right wall only, which solvers treat mirrored.
Problem mirrored() {
  return tests::with_noise(System({.damping = 0.2, .constant = 0.3, .stiffness = 1},
                                  WallParameters{.right = 0.4, .right_restitution = 1}),
                           0.4);
}
Problem gap() {
  return tests::with_noise(
      System({.damping = 0.2, .stiffness = 1}, WallParameters{.left = -0.5, .left_restitution = 1}),
      0.4);
}
Problem two_walls() {
  return tests::with_noise(
      System({.damping = 0.2, .stiffness = 1},
             {.left = -0.5, .left_restitution = 1, .right = 1, .right_restitution = 1}),
      0.4);
}
Problem ring() {
  return tests::with_noise(
      System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
      0.4);
}

struct NamedProblem {
  std::string name;
  Problem problem;
};
std::vector<NamedProblem> with_exact_laws() {
  return {{"bistable", bistable()},
          {"mirrored", mirrored()},
          {"gap", gap()},
          {"two walls", two_walls()},
          {"ring", ring()}};
}

DensityQuadratureGrid points_of(const Problem& problem) {
  return {compare::comparison_bins(problem), problem.system.walls()};
}

Method own_law(const Problem& problem, const ExternalDensity& own = {.label = "own"}) {
  const exact::EnergyLaw law(problem);
  const DensityQuadratureGrid points = points_of(problem);
  std::vector<double> values;
  for (const double y : points.y_points()) {
    for (const double v : points.v_points()) values.push_back(law(y, v));
  }
  return make_method_from_density_values(own, {}, points, values);
}

transform::Solution solved(const Method& method, const Problem& problem) {
  if (method.check) method.check(problem);
  return solve_with_method(method, problem, {compare::comparison_bins(problem), {}});
}

using tests::refusal;

// L1 distance from the exact law over the comparison bins.
double distance_from_law(const transform::Solution& solution, const Problem& problem,
                         StateVariable variable) {
  const exact::EnergyLaw law(problem);
  const auto axes = compare::comparison_bins(problem);
  const auto m = marginal(solution, variable, compare::comparison_bin_edges(axes, variable));
  const double third = std::sqrt(0.6);
  double sum = 0;
  for (std::size_t b = 0; b < m.size(); ++b) {
    const auto p = [&](double at) {
      const double x = m.bin_centre(b) + at * m.bin_width(b) / 2;
      return variable == StateVariable::y ? law.displacement_marginal(x) : law.velocity_marginal(x);
    };
    sum += m.bin_width(b) * std::abs(m.density[b] - (5 * p(-third) + 8 * p(0) + 5 * p(third)) / 18);
  }
  return sum;
}

TEST(ExternalMethodsOfAnyOscillator, ReproduceExactDensities) {
  for (const auto& [name, problem] : with_exact_laws()) {
    SCOPED_TRACE(name);
    const exact::EnergyLaw law(problem);
    const auto own = solved(own_law(problem), problem);
    EXPECT_EQ(own.status, Status::ok) << own.reason;
    EXPECT_NEAR(transform::metric_number(own.metrics, "normalised_by").value(), 1, 1e-6);
    EXPECT_NEAR(own.moments.y1, law.moment(1, 0), 1e-6);
    EXPECT_NEAR(own.moments.y2, law.moment(2, 0), 1e-6);
    EXPECT_NEAR(own.moments.v2, law.moment(0, 2), 1e-6);
    EXPECT_NEAR(own.energy_residual, 0, 1e-6);
    EXPECT_NEAR(transform::metric_number(own.metrics, "balances.virial").value(), 0, 1e-6);
    const auto momentum = transform::metric_number(own.metrics, "balances.momentum");
    EXPECT_EQ(momentum.has_value(), name != "bistable" && name != "ring");
    EXPECT_NEAR(momentum.value_or(0), 0, 1e-6);
    for (const auto variable : transform::kVariables) {
      EXPECT_LT(distance_from_law(own, problem, variable), 1e-6);
    }
    EXPECT_FALSE(transform::metric_text(own.metrics, "notes[0]"));
  }
}

TEST(ExternalMethodsOfAnyOscillator, HaveErrorEstimatesIfTheirEquationIsGiven) {
  for (const auto& problem : {bistable(), mirrored()}) {
    const auto one = run_cases(
        {problem}, {own_law(problem, {.label = "own", .equation = DensityEquation::white})}, 0, {});
    const auto& own = one.front().solutions.front();
    EXPECT_EQ(own.status, Status::ok) << own.reason;
    ASSERT_TRUE(own.error);
    EXPECT_LT(own.error->y_l1, 3e-3);
    EXPECT_LT(own.error->ydot_l1, 3e-3);
  }
}

TEST(ExternalMethodsOfAnyOscillator, AreCutOffOnlyAtEndsWithoutAWall) {
  const auto status_of = [](const Problem& problem) {
    const DensityQuadratureGrid points = points_of(problem);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.y_points().size(); ++i) {
      for (const double v : points.v_points()) values.push_back(std::exp(-8 * v * v));
    }
    return solved(make_method_from_density_values({.label = "own"}, {}, points, values), problem)
        .reason;
  };
  EXPECT_EQ(status_of(two_walls()), "");
  EXPECT_TRUE(contains(status_of(mirrored()), "), at y = -"));
  EXPECT_TRUE(contains(status_of(bistable()), "), at y = -"));
}

TEST(ExternalMethodsOfAnyOscillator, HaveCellsBeyondTheAxesWithoutAWall) {
  const auto ends = [](const Problem& problem) {
    const auto axes = compare::comparison_bins(problem);
    const auto points = points_of(problem);
    return std::pair{(axes.y_edges.front() - points.y_edges().front()) /
                         (axes.y_edges.back() - axes.y_edges.front()),
                     (points.y_edges().back() - axes.y_edges.back()) /
                         (axes.y_edges.back() - axes.y_edges.front())};
  };
  constexpr double kAll = 3.0 / 7, kHalf = kAll / 2, kCell = 1.0 / 140;
  EXPECT_NEAR(ends(bistable()).first, kHalf, kCell);
  EXPECT_NEAR(ends(bistable()).second, kHalf, kCell);
  EXPECT_NEAR(ends(mirrored()).first, kAll, kCell);
  EXPECT_EQ(ends(mirrored()).second, 0);
  EXPECT_EQ(ends(two_walls()), (std::pair{0.0, 0.0}));
  // Cells do not begin at a wall beyond the reach of the motion, but no cell is behind this wall.
  Problem far = tests::with_noise(
      System({.damping = 0.2, .stiffness = 1}, WallParameters{.left = -9, .left_restitution = 1}),
      0.4);
  const auto points = points_of(far);
  EXPECT_FALSE(points.has_wall_at_start());
  EXPECT_GE(points.y_edges().front(), -9);
  EXPECT_LT(points.y_edges().front(), -8.5);
}

class FilesOfAnyOscillator : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  // Writes a marginal at centres of cells, or over bins, between two ends.
  std::string marginal_of(const Problem& problem, double from, double to, bool bins) const {
    const exact::EnergyLaw law(problem);
    std::ofstream out(path("y.csv"));
    out << (bins ? "lower,upper,density\n" : "y,p\n");
    constexpr int kCells = 200;
    const double width = (to - from) / kCells;
    for (int k = 0; k < kCells; ++k) {
      const double y = from + (k + 0.5) * width, p = law.displacement_marginal(y);
      out << (bins ? fmt::format("{},{},{}\n", y - width / 2, y + width / 2, p)
                   : fmt::format("{},{}\n", y, p));
    }
    return path("y.csv");
  }
  std::string joint_of(const Problem& problem, double from, double to) const {
    const exact::EnergyLaw law(problem);
    std::ofstream out(path("joint.csv"));
    out << "y,v,p\n";
    constexpr int kCells = 160;
    for (int i = 0; i < kCells; ++i) {
      const double y = from + (to - from) * (i + 0.5) / kCells;
      for (int j = -kCells / 2; j <= kCells / 2; ++j) {
        const double v = 6.0 * j / kCells * 2;
        out << fmt::format("{},{},{}\n", y, v, law(y, v));
      }
    }
    return path("joint.csv");
  }
  transform::Solution of(const std::string& argument, const Problem& problem) const {
    return solved(
        external_density_methods_from_files(std::vector{argument}, builtin_registry()).front(),
        problem);
  }

  tests::TemporaryDirectory directory_;
};

TEST_F(FilesOfAnyOscillator, OfMarginalsMayHaveAnySignOfY) {
  for (const auto& [problem, from, to] :
       {std::tuple{bistable(), -2.5, 2.5}, std::tuple{mirrored(), -6.0, 0.4},
        std::tuple{two_walls(), -0.5, 1.0}, std::tuple{gap(), -0.5, 6.0}}) {
    SCOPED_TRACE(from);
    const auto own = of(marginal_of(problem, from, to, false), problem);
    EXPECT_LT(distance_from_law(own, problem, StateVariable::y), 1e-3);
    EXPECT_EQ(transform::metric_text(own.metrics, "files[0].variable"), "y");
    // Extrapolated to the walls from the centres of the cells: no note on a cut-off.
    EXPECT_FALSE(transform::metric_text(own.metrics, "files[0].notes[0]"))
        << *transform::metric_text(own.metrics, "files[0].notes[0]");
    EXPECT_NEAR(own.moments.y1, exact::EnergyLaw(problem).moment(1, 0), 1e-3);
    EXPECT_NEAR(own.mass, 1, 1e-3);
  }
}

TEST_F(FilesOfAnyOscillator, OfBothMarginalsHaveAVirialResidual) {
  for (const auto& problem : {bistable(), mirrored(), gap()}) {
    const exact::EnergyLaw law(problem);
    const double to = problem.system.right_wall() ? 0.4 : 6,
                 from = problem.system.left_wall() ? -0.5 : -6;
    const auto y = marginal_of(problem, from, to, false);
    std::ofstream out(path("v.csv"));
    out << "v,p\n";
    for (int k = -200; k <= 200; ++k) {
      out << fmt::format("{},{}\n", 0.03 * k, law.velocity_marginal(0.03 * k));
    }
    out.close();
    const auto methods = external_density_methods_from_files(
        std::vector{y + ":lab", path("v.csv") + ":lab"}, builtin_registry());
    const auto own = solved(methods.front(), problem);
    EXPECT_NEAR(transform::metric_number(own.metrics, "balances.virial").value(), 0, 2e-3);
  }
}

TEST_F(FilesOfAnyOscillator, OfJointDensitiesReproduceTheDensity) {
  for (const auto& [problem, from, to] :
       {std::tuple{bistable(), -2.5, 2.5}, std::tuple{mirrored(), -6.0, 0.4},
        std::tuple{two_walls(), -0.5, 1.0}}) {
    SCOPED_TRACE(from);
    const auto own = of(joint_of(problem, from, to), problem);
    EXPECT_EQ(own.status, Status::ok) << own.reason;
    EXPECT_LT(distance_from_law(own, problem, StateVariable::y), 3e-3);
    EXPECT_LT(distance_from_law(own, problem, StateVariable::ydot), 3e-3);
    const auto momentum = transform::metric_number(own.metrics, "balances.momentum");
    EXPECT_NEAR(momentum.value_or(0), 0, 2e-3);
  }
}

TEST_F(FilesOfAnyOscillator, OfARunReproduceItsDensities) {
  for (const auto& problem : {bistable(), mirrored(), two_walls()}) {
    const auto axes = compare::comparison_bins(problem);
    const exact::EnergyLaw law(problem);
    transform::GridDensity cells{axes.y_edges, axes.v_edges, {}};
    for (std::size_t i = 0; i < cells.y_cell_count(); ++i) {
      for (std::size_t j = 0; j < cells.v_cell_count(); ++j) {
        cells.averages.push_back(law((cells.y_edges[i] + cells.y_edges[i + 1]) / 2,
                                     (cells.v_edges[j] + cells.v_edges[j + 1]) / 2));
      }
    }
    transform::Solution kept;
    kept.identity =
        tests::identity("fd-kf", "fd", DensityEquation::kf, problem::ImpactCondition::map);
    kept.status = Status::ok;
    kept.mass = 1;
    kept.density = cells;
    const results::Run run{results::current_program("fpkcheck run"),
                           {results::make_case_result(problem, axes, {kept})}};
    std::ofstream(path("joint.nc"), std::ios::binary) << results::joint_netcdf_bytes(run);
    const auto own = of(path("joint.nc") + ",solution=fd-kf", problem);
    EXPECT_EQ(own.status, Status::ok) << own.reason;
    EXPECT_LT(distance_from_law(own, problem, StateVariable::y), 1e-3);
    EXPECT_LT(distance_from_law(own, problem, StateVariable::ydot), 1e-3);
  }
  // The last density has y >= -0.5.
  EXPECT_TRUE(
      contains(refusal([&] {
                 of(path("joint.nc") + ",solution=fd-kf",
                    tests::with_noise(System({.damping = 0.2, .stiffness = 1},
                                             WallParameters{.left = 0, .left_restitution = 0.9}),
                                      0.4));
               }),
               "y = -0.5 (must be y >= 0)"));
}

TEST_F(FilesOfAnyOscillator, AreRefusedBehindAWall) {
  const auto of_bistable = marginal_of(bistable(), -2.5, 2.5, false);
  EXPECT_TRUE(contains(refusal([&] { of(of_bistable, gap()); }),
                       "under the names 'y,p' (must be y >= -0.5; name the abscissa 'v'"));
  EXPECT_TRUE(contains(refusal([&] { of(of_bistable, mirrored()); }), "(must be y <= 0.4; name"));
  EXPECT_TRUE(contains(refusal([&] { of(of_bistable, two_walls()); }), "(must be -0.5 <= y <= 1;"));
  std::ofstream bins(path("bins.csv"));
  bins << "lower,upper,p(y)\n-1,-0.5,0.5\n-0.5,0,1\n0,0.3,1\n0.3,0.5,1\n";
  bins.close();
  EXPECT_TRUE(contains(refusal([&] { of(path("bins.csv"), mirrored()); }),
                       "bins.csv:5: y = 0.5 under the names"));
  EXPECT_TRUE(contains(refusal([&] { of(joint_of(bistable(), -2.5, 2.5), two_walls()); }),
                       "(must be -0.5 <= y <= 1)"));
  const std::vector<double> y(200, -0.6), v(200, 0.1);
  const auto samples =
      make_method_from_samples({.label = "a"}, transform::kExternalFunction, {y, v});
  EXPECT_EQ(refusal([&] { samples.check(gap()); }), "samples 'a': y = -0.6 (must be y >= -0.5)");
  EXPECT_EQ(refusal([&] { samples.check(bistable()); }), "accepted");
}

// Extrapolation to a right wall and to a left wall give the same errors for mirror images.
TEST(ExternalMethodsOfAnyOscillator, HaveTheErrorsOfTheirMirrorImages) {
  const auto read = [](const std::string& text, const Walls& walls) {
    std::istringstream in("y p error\n" + text);
    return ExternalMarginal(read_number_table(in, "mine.csv"), walls);
  };
  const auto left = read("0.5 0.3 0.01\n1.5 0.4 0.03\n2.5 0.2 0.02\n3.5 0.1 0.01\n",
                         {.left = Wall{0, 1}, .right = {}});
  const auto right = read("-3.5 0.1 0.01\n-2.5 0.2 0.02\n-1.5 0.4 0.03\n-0.5 0.3 0.01\n",
                          {.left = {}, .right = Wall{0, 1}});
  const std::vector<double> edges{0, 0.25, 0.5, 1, 3}, turned{-3, -1, -0.5, -0.25, 0};
  const auto a = left.average_over_bins(edges), b = right.average_over_bins(turned);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::size_t other = a.size() - 1 - k;
    EXPECT_NEAR(a.density[k], b.density[other], 1e-12);
    EXPECT_NEAR(a.upper[k], b.upper[other], 1e-12);
    EXPECT_NEAR(a.lower[k], b.lower[other], 1e-12);
  }
  EXPECT_GT(a.density[0], 0.1);
  EXPECT_NEAR(left.l1_sampling_error(edges).expected, right.l1_sampling_error(turned).expected,
              1e-12);
  EXPECT_GT(left.l1_sampling_error(edges).expected, 0);
}

TEST(ExternalMethodsOfAnyOscillator, NoteTheMissingMassAtRest) {
  const Problem pressed = tests::with_impulses(
      System({.damping = 0.1, .constant = 0.5, .stiffness = 1, .restitution = 0.7}),
      tests::gaussian_impulses(1, 0.5));
  std::vector<double> y(1000), v(1000);
  for (std::size_t k = 0; k < y.size(); ++k) {
    y[k] = k < 250 ? 0 : 0.001 * static_cast<double>(k);
    v[k] = k < 250 ? 0 : 0.3;
  }
  const auto own = solved(
      make_method_from_samples({.label = "a"}, transform::kExternalFunction, {y, v}), pressed);
  EXPECT_NEAR(own.mass, 0.75, 1e-12);
  EXPECT_EQ(own.estimated_marginals.front().second.density[0], 0);
  EXPECT_TRUE(
      contains(transform::metric_text(own.metrics, "notes[0]").value(), "at rest in contact"));
  // Under white noise no mass is at rest.
  Problem lifted = pressed;
  lifted.noise.intensity = 0.1;
  const auto all = solved(
      make_method_from_samples({.label = "a"}, transform::kExternalFunction, {y, v}), lifted);
  EXPECT_NEAR(all.mass, 1, 1e-12);
  EXPECT_FALSE(transform::metric_text(all.metrics, "notes[0]"));
}

}  // namespace
}  // namespace fpkcheck::methods
