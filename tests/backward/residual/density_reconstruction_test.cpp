#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "backward/residual/density_reconstruction.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::backward {
namespace {

/// Cell averages of a function with a known integral.
template <class Integral>
Eigen::VectorXd averages_between(const std::vector<double>& edges, const Integral& integral) {
  Eigen::VectorXd averages(std::ssize(edges) - 1);
  for (Eigen::Index k = 0; k < averages.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    averages(k) = (integral(edges[at + 1]) - integral(edges[at])) / (edges[at + 1] - edges[at]);
  }
  return averages;
}

TEST(Reconstruction, IsExactForDegree6OnUnequalCells) {
  const std::vector<double> edges{0, 0.3, 0.5, 0.9, 1.4, 1.5, 2.2, 2.4, 3.1, 3.3, 4};
  const std::vector<double> points{0, 0.01, 0.5, 1.45, 2.0, 3.99, 4};
  for (int n = 0; n <= 7; ++n) {
    const auto averages =
        averages_between(edges, [&](double x) { return std::pow(x - 2, n + 1) / (n + 1); });
    const Eigen::VectorXd values = density_reconstruction_matrix(edges, points) * averages;
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double error = values(static_cast<Eigen::Index>(k)) - std::pow(points[k] - 2, n);
      worst = std::max(worst, std::abs(error));
    }
    if (n <= 6) {
      EXPECT_LT(worst, 1e-11) << n;
    } else {
      EXPECT_GT(worst, 1e-2) << n;
    }
  }
}

TEST(Reconstruction, DoesNotReachAcrossAJumpAt0NorBeyondTheEnds) {
  const std::vector<double> edges = tests::uniform_edges(-2, 2, 20);
  // The function is 3 - x for x < 0 and x^2 for x > 0.
  const auto averages = averages_between(
      edges, [](double x) { return x < 0 ? 3 * x - x * x / 2 : std::pow(x, 3) / 3; });
  const std::vector<double> points{-2.1, -2, -0.05, -1e-9, 0, 0.05, 2, 2.1};
  const std::vector<double> expected{0, 5, 3.05, 3, 0, 0.0025, 4, 0};
  const Eigen::VectorXd values = density_reconstruction_matrix(edges, points) * averages;
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(values(static_cast<Eigen::Index>(k)), expected[k], 1e-8) << points[k];
  }
}

TEST(Reconstruction, OfASmoothFunctionIsOfSeventhOrder) {
  const std::vector<double> points = tests::uniform_edges(-2.9, 2.9, 1999);
  std::vector<double> errors;
  for (const int cells : {40, 60, 90}) {
    const auto edges = tests::uniform_edges(-3, 3, cells);
    const Eigen::VectorXd values =
        density_reconstruction_matrix(edges, points) * averages_between(edges, [](double x) {
          return std::sqrt(std::acos(-1.0)) / 2 * std::erf(x);
        });
    double worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      worst = std::max(
          worst, std::abs(values(static_cast<Eigen::Index>(k)) - std::exp(-points[k] * points[k])));
    }
    errors.push_back(worst);
  }
  for (const std::size_t k : {0U, 1U}) {
    const double order = std::log(errors[k] / errors[k + 1]) / std::log(1.5);
    EXPECT_GT(order, 6.2) << errors[k] << ' ' << errors[k + 1];
    EXPECT_LT(order, 8.4) << errors[k] << ' ' << errors[k + 1];
  }
}

}  // namespace
}  // namespace fpkcheck::backward
