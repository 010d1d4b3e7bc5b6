#include "methods/external/joint_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "exact/closed_forms.hpp"
#include "methods/external/range_between_walls.hpp"
#include "paper_cases.hpp"
#include "refusal.hpp"
#include "saved_run.hpp"

namespace fpkcheck::methods {
namespace {

using tests::contains;
using transform::StateVariable;

JointTable read_joint(const std::string& text) {
  std::istringstream in(text);
  const auto table = read_number_table(in, "mine.csv");
  EXPECT_TRUE(is_joint_density(table));
  return make_joint_table(table);
}

std::string refusal_of_joint(const std::string& text) {
  return tests::refusal([&] { read_joint(text); });
}

// Joint densities at r = 1 under white noise, where the density is known exactly.
class JointTables : public testing::Test {
 protected:
  // Cells or points over 10 standard deviations of y, twice as many over those of y'.
  std::string file(int n, const char* names = "y,v,p", bool swapped = false) const {
    std::string text = std::string(names) + '\n';
    for (int i = 0; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const double y = kEnd * i / n, v = kEnd * j / n;
        text += fmt::format("{},{},{}\n", swapped ? v : y, swapped ? y : v, 2 * exact_(y, v));
      }
    }
    return text;
  }

  double l1_of_y(const JointTable& table) const {
    const auto values = evaluate_at_quadrature_points(table, points_);
    const auto averages = DensityIntegrals(points_, values).cell_averages();
    const auto found = transform::marginal(averages, StateVariable::y, axes_.y_edges);
    double sum = 0;
    for (std::size_t b = 0; b < found.size(); ++b) {
      const double width = found.bin_width(b), centre = found.bin_centre(b);
      const auto p = [&](double at) { return exact_.displacement_marginal(at); };
      const double offset = width / 2 * std::sqrt(0.6);
      const double exact = (5 * p(centre - offset) + 8 * p(centre) + 5 * p(centre + offset)) / 18;
      sum += width * std::abs(found.density[b] - exact);
    }
    return sum;
  }

  static constexpr double kEnd = 6;
  problem::Problem problem_ = tests::make_problem({.restitution = 1});
  compare::ComparisonBins axes_ = compare::comparison_bins(problem_);
  DensityQuadratureGrid points_{axes_, problem_.system.walls()};
  exact::WhiteNoiseDensity exact_{problem_};
};

TEST_F(JointTables, AreInterpolatedToThirdOrder) {
  const double coarse = l1_of_y(read_joint(file(24))), middle = l1_of_y(read_joint(file(48))),
               fine = l1_of_y(read_joint(file(96)));
  const double first = std::log2(coarse / middle), second = std::log2(middle / fine);
  // The slopes of Akima's interpolant have order 2, at extrema order 1.
  EXPECT_GT(first, 2.5) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_LT(first, 4.2) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_GT(second, 2.5) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_LT(second, 4.2) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_LT(fine, 2e-4);
}

TEST_F(JointTables, MayHaveTheirColumnsAndRowsInAnyOrder) {
  const auto default_ids = read_joint(file(8));
  const auto swapped = read_joint(file(8, "velocity;x;density", true));
  EXPECT_EQ(default_ids.y, swapped.y);
  EXPECT_EQ(default_ids.v, swapped.v);
  EXPECT_EQ(default_ids.p, swapped.p);
}

TEST_F(JointTables, AreExtrapolatedToTheWall) {
  std::string text = "y,v,p\n";
  for (int i = 0; i < 30; ++i) {
    for (int j = -30; j <= 30; ++j) {
      text += fmt::format("{},{},{}\n", 0.2 * (i + 0.5), 0.2 * j,
                          std::exp(-0.04 * j * j) * std::max(0.0, 5.0 - i));
    }
  }
  const auto values = evaluate_at_quadrature_points(read_joint(text), points_);
  // On the straight line through the first two points: 5 at y = 0.1 and 4 at y = 0.3.
  const std::size_t nv = points_.v_points().size(), middle = nv / 2;
  EXPECT_NEAR(values[middle] / values[nv * 2 + middle], 5.5 / (5.5 - 5 * points_.y_points()[2]),
              1e-6);
}

TEST_F(JointTables, OfCellsConserveTheirAverages) {
  transform::GridDensity cells{axes_.y_edges, axes_.v_edges, {}};
  for (std::size_t i = 0; i < cells.y_cell_count(); ++i) {
    for (std::size_t j = 0; j < cells.v_cell_count(); ++j) {
      const double y = (cells.y_edges[i] + cells.y_edges[i + 1]) / 2;
      const double v = (cells.v_edges[j] + cells.v_edges[j + 1]) / 2;
      cells.averages.push_back(2 * exact_(y, v));
    }
  }
  const auto values = evaluate_at_quadrature_points(cells, points_);
  const DensityIntegrals integrals(points_, values);
  EXPECT_NEAR(integrals.mass(), transform::mass(cells), 1e-12);
  const auto averages = integrals.cell_averages();
  std::size_t j0 = 0;
  while (averages.v_edges[j0] < cells.v_edges[0] - 1e-9) ++j0;
  for (const std::size_t i : {0, 7, 40}) {
    for (const std::size_t j : {5, 100, 120}) {
      EXPECT_NEAR(averages.cell_average(i, j0 + j), cells.cell_average(i, j), 1e-12)
          << i << ' ' << j;
    }
  }
  const double wall = values[points_.v_points().size() / 2];
  EXPECT_NEAR(wall / (2 * exact_(0, points_.v_points()[points_.v_points().size() / 2])), 1, 1e-3);
}

TEST_F(JointTables, AreRefusedIfIncomplete) {
  const std::string whole = file(4);
  const auto last = whole.substr(0, whole.size() - 1).rfind('\n');
  EXPECT_TRUE(contains(refusal_of_joint(whole.substr(0, last + 1)),
                       "mine.csv: 44 rows with 5 values of y and 9 of y' (must be one for every"));
  EXPECT_TRUE(
      contains(refusal_of_joint(whole + "0,0,1\n"), "mine.csv:47: y = 0, y' = 0 occurs twice"));
  EXPECT_TRUE(contains(refusal_of_joint(file(2)), "3 values of y (must be at least 4)"));
  EXPECT_EQ(refusal_of_joint(whole), "accepted");
  std::istringstream marginal("y,v,error\n0,1,2\n1,2,3\n2,3,4\n3,4,5\n");
  EXPECT_FALSE(is_joint_density(read_number_table(marginal, "mine.csv")));
}

}  // namespace
}  // namespace fpkcheck::methods
