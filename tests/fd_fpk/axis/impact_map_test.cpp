#include "fd_fpk/axis/impact_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

using problem::ImpactCondition;

GridAxis speeds(int cells, double h = 1) { return GridAxis::with_uniform_cells(0, h, cells); }

// Outgoing flux f(u) = u exp(-u^2/2) and its primitive.
double cumulative(double u) { return 1 - std::exp(-u * u / 2); }

// Averages of f(w/r)/r over cells of width h.
Eigen::VectorXd returned(int cells, double h, double r) {
  Eigen::VectorXd averages(cells);
  for (int a = 0; a < cells; ++a) {
    averages(a) = (cumulative((a + 1) * h / r) - cumulative(a * h / r)) / h;
  }
  return averages;
}

double error(int cells, double r, int order) {
  const double h = 8.0 / cells;
  return (impact_map(speeds(cells, h), {0, r}, ImpactCondition::map, order) *
              returned(cells, h, 1.0) -
          returned(cells, h, r))
             .lpNorm<1>() *
         h;
}

TEST(ImpactMap, IsTheIdentityWithoutLosses) {
  const Eigen::MatrixXd map = impact_map(speeds(20), {0, 1.0}, ImpactCondition::map, 5);
  EXPECT_LT((map - Eigen::MatrixXd::Identity(20, 20)).norm(), 1e-12);
}

TEST(ImpactMap, ConservesProbabilityForEveryRestitution) {
  for (const double r : {1.0, 0.98, 0.7, 0.31, 0.05}) {
    const Eigen::MatrixXd map = impact_map(speeds(24), {0, r}, ImpactCondition::map, 5);
    EXPECT_LT((map.colwise().sum().array() - 1).abs().maxCoeff(), 1e-12) << r;
  }
}

TEST(ImpactMap, ScalesSpeedByTheRestitutionWithTheRequestedOrder) {
  for (const int order : {3, 5}) {
    for (const double r : {0.93, 0.6}) {
      const double coarse = error(32, r, order), middle = error(64, r, order),
                   fine = error(128, r, order);
      for (const double observed : {std::log2(coarse / middle), std::log2(middle / fine)}) {
        EXPECT_GT(observed, order - 0.6) << r << ": " << coarse << " " << middle << " " << fine;
        EXPECT_LT(observed, order + 1.6) << r << ": " << coarse << " " << middle << " " << fine;
      }
    }
  }
}

TEST(ImpactMap, MeanReturnedEnergyFallsByTheSquareOfTheRestitution) {
  const int cells = 80;
  const double h = 0.1, r = 0.8;
  const Eigen::VectorXd in =
      impact_map(speeds(cells, h), {0, r}, ImpactCondition::map, 5) * returned(cells, h, 1.0);
  double energy = 0;
  for (int a = 0; a < cells; ++a) energy += in(a)*h * ((a + 0.5) * h) * ((a + 0.5) * h);
  EXPECT_NEAR(energy, r * r * 2.0, 2e-3);  // E[u^2] = 2 under f
}

Eigen::VectorXd half_normal_flux(const GridAxis& axis) {
  Eigen::VectorXd averages(axis.cell_count());
  for (int a = 0; a < axis.cell_count(); ++a) {
    averages(a) = (cumulative(axis.face_position(a + 1)) - cumulative(axis.face_position(a))) /
                  axis.cell_width(a);
  }
  return averages;
}

TEST(ImpactMap, DeltaIsTheFirstOrderTermAndItsErrorIsOfSecondOrder) {
  // || map f - delta f ||_1 is of order (1-r)^2: a factor of 4 for half the loss.
  const GridAxis axis = speeds(200, 0.04);
  const Eigen::VectorXd flux = half_normal_flux(axis);
  const auto difference = [&](double loss) {
    const Eigen::VectorXd d = (impact_map(axis, {0, 1 - loss}, ImpactCondition::map, 7) -
                               impact_map(axis, {0, 1 - loss}, ImpactCondition::delta, 7)) *
                              flux;
    return axis.cell_widths().dot(d.cwiseAbs());
  };
  const double large = difference(0.04), middle = difference(0.02), small = difference(0.01);
  for (const double order : {std::log2(large / middle), std::log2(middle / small)}) {
    EXPECT_GT(order, 1.9) << large << " " << middle << " " << small;
    EXPECT_LT(order, 2.15) << large << " " << middle << " " << small;
  }
}

TEST(ImpactMap, DeltaIsFluxPlusLossTimesItsScaling) {
  // f + (1-r) d(w f)/dw for f = w exp(-w^2/2): averages of f and differences of w f.
  const GridAxis axis = speeds(160, 0.05);
  const double loss = 0.1;
  const Eigen::VectorXd in =
      impact_map(axis, {0, 1 - loss}, ImpactCondition::delta, 7) * half_normal_flux(axis);
  const auto scaled = [](double w) { return w * w * std::exp(-w * w / 2); };
  for (int a = 0; a < 100; ++a) {
    const double exact = half_normal_flux(axis)(a) +
                         loss *
                             (scaled(axis.face_position(a + 1)) - scaled(axis.face_position(a))) /
                             axis.cell_width(a);
    EXPECT_NEAR(in(a), exact, 2e-7) << a;
  }
}

TEST(ImpactMap, KeepsProbabilityOnUnequalCellsInBothForms) {
  const GridAxis axis({0, 0.1, 0.22, 0.36, 0.5, 0.7, 0.95, 1.2, 1.5, 1.9, 2.3, 2.8});
  for (const ImpactCondition impact : {ImpactCondition::map, ImpactCondition::delta}) {
    const Eigen::MatrixXd map = impact_map(axis, {0, 0.8}, impact, 5);
    const Eigen::RowVectorXd kept = axis.cell_widths().transpose() * map;
    EXPECT_LT((kept - axis.cell_widths().transpose()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
