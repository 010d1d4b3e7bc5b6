#include "fd_fpk/impact_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

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
  return (impact_map(cells, r, order) * returned(cells, h, 1.0) - returned(cells, h, r))
             .lpNorm<1>() *
         h;
}

TEST(ImpactMap, IsTheIdentityWithoutLosses) {
  const Eigen::MatrixXd map = impact_map(20, 1.0, 5);
  EXPECT_LT((map - Eigen::MatrixXd::Identity(20, 20)).norm(), 1e-12);
}

TEST(ImpactMap, KeepsProbabilityWhateverTheRestitution) {
  for (const double r : {1.0, 0.98, 0.7, 0.31, 0.05}) {
    const Eigen::MatrixXd map = impact_map(24, r, 5);
    EXPECT_LT((map.colwise().sum().array() - 1).abs().maxCoeff(), 1e-12) << r;
  }
}

TEST(ImpactMap, ScalesSpeedByTheRestitutionToTheOrderAsked) {
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
  const Eigen::VectorXd in = impact_map(cells, r, 5) * returned(cells, h, 1.0);
  double energy = 0;
  for (int a = 0; a < cells; ++a) energy += in(a)*h * ((a + 0.5) * h) * ((a + 0.5) * h);
  EXPECT_NEAR(energy, r * r * 2.0, 2e-3);  // E[u^2] = 2 under f
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
