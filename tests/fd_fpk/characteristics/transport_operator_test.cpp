#include "fd_fpk/characteristics/transport_operator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "fd_fpk/characteristics/characteristic_grid.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

struct TransportSetup {
  problem::Problem problem;
  PhasePlaneGrid grid;
  Characteristics characteristics;
  DensitySlopeReconstruction slopes;

  explicit TransportSetup(const problem::Problem& p, double refinement = 0.5)
      : problem(p),
        grid(characteristic_grid(p, problem::motion_scales(p), {.refinement = refinement},
                                 {.x1_max = 4, .x2_max = 4})),
        characteristics(p.system, grid, p.impulses.arrival_rate(), 8),
        slopes(grid, characteristics.rest_points()) {}

  // A smooth density of mass 1 inside the box.
  Eigen::VectorXd masses() const {
    return gaussian_cell_averages({0.4, 0.5}, grid).cwiseProduct(grid.cell_areas());
  }
  TransportOperator::TransportedMasses transported(const Eigen::VectorXd& q,
                                                   ImpactSumsOfBothWalls* impacts = nullptr) const {
    return TransportOperator(characteristics, problem.impulses.amplitude_law())(q, slopes(q),
                                                                                impacts);
  }
  Eigen::VectorXd passed(const Eigen::VectorXd& q, ImpactSumsOfBothWalls* impacts = nullptr) const {
    return transported(q, impacts).ended;
  }
  // Mean over cells with uniform density.
  double mean(const Eigen::VectorXd& m, const auto& of) const {
    double sum = 0;
    for (int i = 0; i < grid.nx(); ++i) {
      for (int j = 0; j < grid.v_cell_count(); ++j) {
        sum += m(i * grid.v_cell_count() + j) * of(grid.x1.cell_centre(i), grid.x2.cell_centre(j));
      }
    }
    return sum;
  }
};

std::vector<problem::Problem> problems() {
  return {tests::make_problem({.damping = 0.3, .restitution = 0.7}),
          tests::make_problem({.damping = 4, .cubic = 0, .restitution = 0.5}),
          tests::make_problem({.damping = 0.05, .cubic = 3, .restitution = 1, .rate = 0.05})};
}

TEST(TransportOperator, ConservesMassAndSign) {
  for (const auto& p : problems()) {
    const TransportSetup s(p);
    const Eigen::VectorXd p_masses = s.passed(s.masses());
    EXPECT_NEAR(p_masses.sum(), s.masses().sum(), 1e-12);
    EXPECT_GT(p_masses.minCoeff(), -1e-9);
  }
}

// The van der Pol oscillator has a limit cycle around its unstable equilibrium. A characteristic
// ends there after 7 mean times between impulses.
TEST(TransportOperator, ContinuesTheMassAtTheEndsAlongALimitCycle) {
  const problem::System system({.damping = -1, .van_der_pol = 1, .stiffness = 1}, {.none = true});
  const problem::Problem p = tests::with_impulses(system, tests::gaussian_impulses(1, 0.5));
  const PhasePlaneBox box{.x1_max = 5, .x2_max = 6, .x1_min = -5};
  const PhasePlaneGrid grid =
      characteristic_grid(p, problem::motion_scales(p), {.refinement = 0.5}, box);
  const Characteristics characteristics(system, grid, 1, 8);
  const DensitySlopeReconstruction slopes(grid, characteristics.rest_points());
  const TransportOperator transport(characteristics, p.impulses.amplitude_law());
  const Eigen::VectorXd q = grid.cell_areas() / grid.cell_areas().sum();
  const auto [ended, continuing] = transport(q, slopes(q));
  EXPECT_NEAR(ended.sum() + continuing.sum(), 1, 1e-12);
  EXPECT_GE(continuing.minCoeff(), 0);
  // Mass that starts on the characteristic after its beginning has less time for an impulse.
  EXPECT_GT(continuing.sum(), std::exp(-7));
  EXPECT_LT(continuing.sum(), 0.1);
}

TEST(Characteristics, CoverEveryCellWithFractionsThatSumToOne) {
  for (const auto& p : problems()) {
    const TransportSetup s(p);
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(s.grid.size());
    Eigen::VectorXd y = shares, v = shares;
    for (const CharacteristicCellVisit& visit : s.characteristics.characteristic_cell_visits()) {
      shares(visit.cell) += visit.share;
      y(visit.cell) += visit.share * visit.y;
      v(visit.cell) += visit.share * visit.v;
    }
    std::set<int> resting;
    for (const RestPoint& point : s.characteristics.rest_points()) {
      for (const auto& [cell, share] : point.cells) resting.insert(cell);
    }
    for (int cell = 0; cell < s.grid.size(); ++cell) {
      const bool at_rest = resting.contains(cell);
      EXPECT_NEAR(shares(cell), at_rest ? 0 : 1, 1e-12) << cell;
      EXPECT_NEAR(y(cell), 0, 1e-12) << cell;
      EXPECT_NEAR(v(cell), 0, 1e-12) << cell;
    }
  }
}

// From q to p the mean energy changes by the losses during the mean time 1/lambda: lambda (E_p -
// E_q) = -c E_p[v^2] - (1 - r^2)/2 lambda sum of v^2 over the impacts.
TEST(TransportOperator, LosesTheEnergyThatDampingAndImpactsTake) {
  for (const auto& p : problems()) {
    const double rate = p.impulses.arrival_rate(), r = p.system.restitution();
    std::vector<double> residuals;
    for (const double refinement : {0.5, 1.0}) {
      const TransportSetup s(p, refinement);
      const auto energy = [&](double y, double v) { return v * v / 2 + p.system.potential()(y); };
      const auto square = [](double, double v) { return v * v; };
      ImpactSumsOfBothWalls impacts;
      const Eigen::VectorXd q = s.masses(), after = s.passed(q, &impacts);
      const double gained = rate * (s.mean(after, energy) - s.mean(q, energy));
      const double lost =
          p.system.damping() * s.mean(after, square) + (1 - r * r) / 2 * rate * impacts.left.energy;
      residuals.push_back(std::abs(gained + lost) / lost);
    }
    EXPECT_LT(residuals[0], 0.02);
    EXPECT_LT(residuals[1], std::max(0.5 * residuals[0], 5e-4));
  }
}

// The fraction of a half-cycle with v < 0, weighted by exp(-lambda t): for rare impulses that of
// the damped sine, (pi - atan(2 w / c)) / pi; 1 for overdamped motion.
TEST(Characteristics, MassAtRestOscillates) {
  const double c = 0.8, w = std::sqrt(1 - c * c / 4);
  const TransportSetup s(
      tests::make_problem({.damping = c, .cubic = 0, .restitution = 0.5, .rate = 1e-4}));
  const double turn = std::atan2(2 * w, c);
  const auto& rest = s.characteristics.rest_points().front();
  EXPECT_NEAR(rest.cells.front().share, 1 - turn / std::numbers::pi, 1e-2);
  EXPECT_NEAR(rest.impact_rate, w / std::numbers::pi, 1e-4);
  const TransportSetup creeping(
      tests::make_problem({.damping = 4, .cubic = 0, .restitution = 0.5}));
  EXPECT_EQ(creeping.characteristics.rest_points().front().cells.front().share, 1);
  EXPECT_EQ(creeping.characteristics.rest_points().front().impact_rate, 0);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
