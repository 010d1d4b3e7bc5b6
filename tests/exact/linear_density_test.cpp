#include "exact/linear_density.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "linear_problem.hpp"

namespace fpkcheck::exact {

using namespace problem;

namespace {

std::vector<double> uniform_edges(double from, double to, int bins) {
  std::vector<double> edges(bins + 1);
  for (int n = 0; n <= bins; ++n) edges[n] = from + (to - from) * n / bins;
  return edges;
}

// A density on cells; expectations are computed with the mass of a cell at its centre.
struct Cells {
  double width_y, width_v;
  std::vector<double> y, v;     // centres
  std::vector<double> density;  // row-major (y, v)

  Cells(const LinearDensity& exact, int ny, int nv) {
    const auto y_edges = uniform_edges(0, exact.displacement_range(), ny);
    const auto v_edges = uniform_edges(-exact.velocity_range(), exact.velocity_range(), nv);
    width_y = y_edges[1];
    width_v = v_edges[1] - v_edges[0];
    for (int n = 0; n < ny; ++n) y.push_back((y_edges[n] + y_edges[n + 1]) / 2);
    for (int n = 0; n < nv; ++n) v.push_back((v_edges[n] + v_edges[n + 1]) / 2);
    density = exact.joint_averages(y_edges, v_edges);
  }
  template <class Function>
  double mean(const Function& f) const {
    double sum = 0;
    for (std::size_t n = 0; n < density.size(); ++n) {
      sum += density[n] * f(y[n / v.size()], v[n % v.size()]);
    }
    return sum * width_y * width_v;
  }
};

TEST(LinearDensity, HasTheExactMomentsForEveryLaw) {
  for (const char* law : tests::kSymmetricLaws) {
    SCOPED_TRACE(law);
    const Problem p = tests::linear_problem({.law = law});
    const Cells cells(LinearDensity(p), 160, 320);
    const auto cumulant = [&](int n, int q) { return linear_cumulant(p, n, q); };
    const double y2 = cells.mean([](double y, double) { return y * y; });
    const double v2 = cells.mean([](double, double v) { return v * v; });
    const double y4 = cells.mean([](double y, double) { return y * y * y * y; });
    const double v4 = cells.mean([](double, double v) { return v * v * v * v; });
    const double y2v2 = cells.mean([](double y, double v) { return y * y * v * v; });
    const double yv3 = cells.mean([](double y, double v) { return y * v * v * v; });
    // Sheppard's corrections for moments of bins of width h; exact up to the tails here.
    const double h = cells.width_y * cells.width_y / 12, w = cells.width_v * cells.width_v / 12;
    EXPECT_NEAR(y2 - h, cumulant(2, 0), 1e-11);
    EXPECT_NEAR(v2 - w, cumulant(0, 2), 1e-11);
    EXPECT_NEAR(y4 - 6 * h * y2 + 4.2 * h * h, cumulant(4, 0) + 3 * cumulant(2, 0) * cumulant(2, 0),
                1e-10);
    EXPECT_NEAR(v4 - 6 * w * v2 + 4.2 * w * w, cumulant(0, 4) + 3 * cumulant(0, 2) * cumulant(0, 2),
                1e-10);
    EXPECT_NEAR(y2v2 - h * v2 - w * y2 + h * w, cumulant(2, 2) + cumulant(2, 0) * cumulant(0, 2),
                1e-10);
    EXPECT_NEAR(yv3, cumulant(1, 3), 1e-10);  // E[z z'] = 0; the sign distinguishes z' from -z'
    EXPECT_GT(std::abs(cumulant(1, 3)), 1e-4);
    EXPECT_NEAR(cells.mean([](double, double) { return 1; }), 1, 1e-12);
  }
}

TEST(LinearDensity, HasKnownFourthMoments) {
  const Cells cells(LinearDensity(tests::linear_problem()), 2000, 2000);
  EXPECT_NEAR(cells.mean([](double y, double) { return y * y * y * y; }), 0.8058313, 5e-5);
  EXPECT_NEAR(cells.mean([](double, double v) { return v * v * v * v; }), 0.8063896, 1e-4);
}

TEST(LinearDensity, IsPositiveAndHasConsistentMarginals) {
  for (const char* law : tests::kSymmetricLaws) {
    SCOPED_TRACE(law);
    const LinearDensity density(tests::linear_problem({.law = law}));
    const double far = density.velocity_range();
    std::vector<double> y_edges = uniform_edges(0, 3, 30), v_edges = uniform_edges(-3, 3, 60);
    y_edges.push_back(2 * far);  // a wide last bin covers the whole range
    v_edges.push_back(2 * far);
    v_edges.insert(v_edges.begin(), -2 * far);
    const auto joint = density.joint_averages(y_edges, v_edges);
    const auto py = density.displacement_averages(y_edges);
    const auto pv = density.velocity_averages(v_edges);
    ASSERT_EQ(py.size(), 31u);
    ASSERT_EQ(pv.size(), 62u);
    EXPECT_GT(*std::min_element(joint.begin(), joint.end()), -1e-14);
    for (std::size_t n = 0; n < py.size(); ++n) {
      double sum = 0;
      for (std::size_t m = 0; m < pv.size(); ++m) {
        sum += joint[n * pv.size() + m] * (v_edges[m + 1] - v_edges[m]);
      }
      EXPECT_NEAR(py[n], sum, 1e-13) << n;
    }
    double mass = 0;
    for (std::size_t m = 0; m < pv.size(); ++m) {
      double sum = 0;
      for (std::size_t n = 0; n < py.size(); ++n) {
        sum += joint[n * pv.size() + m] * (y_edges[n + 1] - y_edges[n]);
      }
      EXPECT_NEAR(pv[m], sum, 1e-13) << m;
      mass += pv[m] * (v_edges[m + 1] - v_edges[m]);
    }
    EXPECT_NEAR(mass, 1, 1e-13);
  }
}

// The stationary mean of d/dt |z| z'^2, with E[d/dt |z|^3] = 0, is
//
//     E[y'^3] = 2c ( E[y y'^2] - E[y] E[y'^2] ),
//
// which is zero only for white noise: p(y') of paper (34) is not even under impulses.
TEST(LinearDensity, HasTheThirdMomentOfTheBalance) {
  for (const char* law : tests::kSymmetricLaws) {
    SCOPED_TRACE(law);
    const Problem p = tests::linear_problem({.damping = 0.4, .rate = 4, .law = law});
    const LinearDensity density(p);
    // The kink of |y| at 0 causes an error of second order in the width, removed by extrapolation.
    const auto average_over_cells = [&](int ny) {
      const Cells cells(density, ny, 400);
      const double v2 = p.impulses.intensity() / (2 * p.system.damping());
      const double w = cells.width_v * cells.width_v / 12;
      return std::pair{cells.mean([](double, double v) { return v * v * v; }),
                       2 * p.system.damping() *
                           cells.mean([&](double y, double v) { return y * (v * v - w - v2); })};
    };
    const auto [cube, coarse] = average_over_cells(200);
    const double fine = average_over_cells(400).second;
    EXPECT_NEAR(cube, (4 * fine - coarse) / 3, 1e-8);
    EXPECT_GT(cube, 1e-4);
  }
}

TEST(LinearDensity, OfFrequentImpulsesIsTheGaussianOfWhiteNoise) {
  for (const char* law : tests::kSymmetricLaws) {
    const Problem p = tests::linear_problem({.rate = 1e5, .law = law});
    const LinearDensity density(p);
    const boost::math::normal normal(0, std::sqrt(0.5));
    const auto probability = [&](double a, double b) { return cdf(normal, b) - cdf(normal, a); };
    const auto y = uniform_edges(0, 3, 12), v = uniform_edges(-3, 3, 24);
    const auto joint = density.joint_averages(y, v);
    const double cell = (y[1] - y[0]) * (v[1] - v[0]);
    for (std::size_t n = 0; n < joint.size(); ++n) {
      const std::size_t i = n / 24, j = n % 24;
      // lambda / c = 1e6: the relative fourth cumulants are 1e-6.
      EXPECT_NEAR(joint[n], 2 * probability(y[i], y[i + 1]) * probability(v[j], v[j + 1]) / cell,
                  2e-6)
          << law;
    }
  }
}

TEST(LinearDensity, DoesNotDependOnTheCutOff) {
  for (const char* law : tests::kSymmetricLaws) {
    SCOPED_TRACE(law);
    const Problem p =
        tests::linear_problem({.damping = 0.2, .stiffness = 0.5, .rate = 2, .law = law});
    const auto y = uniform_edges(0, 4, 40), v = uniform_edges(-3, 3, 60);
    const auto sharp = LinearDensity(p).joint_averages(y, v);
    for (const double cutoff : {1e-4, 1e-8, 1e-11}) {
      const LinearDensity density(p, cutoff);
      const auto coarse = density.joint_averages(y, v);
      double error = 0;
      for (std::size_t n = 0; n < coarse.size(); ++n) {
        error = std::max(error, std::abs(coarse[n] - sharp[n]));
      }
      EXPECT_LT(error, density.joint_truncation() + cutoff);
      EXPECT_GT(error, cutoff / 1e5);  // the comparison is sensitive to the cut-off
    }
  }
}

TEST(LinearDensity, CellsOutsideTheRangeAreEmptyAndCellsAcrossItConserveMass) {
  const LinearDensity density(tests::linear_problem());
  const double z = density.displacement_range();
  const auto averages = density.displacement_averages(std::vector{0.0, 1e3 * z, 2e3 * z});
  EXPECT_NEAR(averages[0] * 1e3 * z, 1, 1e-13);
  EXPECT_EQ(averages[1], 0);
}

TEST(LinearDensity, RefusesUnsupportedProblemsAndEdges) {
  EXPECT_THROW(LinearDensity{tests::make_problem()}, InputError);
  EXPECT_THROW(LinearDensity{tests::linear_problem({.rate = 0.1})}, InputError);  // unbounded
  EXPECT_THROW(LinearDensity{tests::linear_problem({.rate = 0.2})}, InputError);  // too many waves
  EXPECT_THROW(LinearDensity(tests::linear_problem(), 0), InputError);
  EXPECT_NO_THROW(LinearDensity(tests::linear_problem({.rate = 0.2}), 1e-4));
  const LinearDensity density(tests::linear_problem());
  EXPECT_THROW(density.displacement_averages(std::vector{-0.1, 1.0}), InputError);
  EXPECT_THROW(density.velocity_averages(std::vector{1.0, 1.0}), InputError);
  EXPECT_THROW(density.joint_averages(std::vector{0.0, 1.0}, std::vector{0.0}), InputError);
}

}  // namespace
}  // namespace fpkcheck::exact
