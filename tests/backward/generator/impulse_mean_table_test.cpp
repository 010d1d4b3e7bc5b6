#include "backward/generator/impulse_mean_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "spline_coefficients.hpp"

namespace fpkcheck::backward {
namespace {

using problem::ImpulseLaw;

constexpr double kDeviation = 0.31;

struct BasisWithTable {
  ImpactSplineBasis basis;
  std::vector<VelocityAxisPiece> pieces;
  PostImpulseMeanTable table;
};

BasisWithTable make_basis_with_table(const ImpulseLaw& law, double end, int cells, double r) {
  return numerics::call_with_upward_rounding([&] {
    const ImpactSplineBasis basis(
        numerics::SplineBasis(numerics::graded_break_points(end, cells, 0.05, end / 3)), r);
    const VelocityPieceConstraints constraints = velocity_piece_constraints(basis, law);
    std::vector<VelocityAxisPiece> pieces =
        divide_velocity_axis(basis, constraints.break_velocities, constraints.max_length);
    PostImpulseMeanTable table = compute_impulse_mean_table(basis, pieces, law);
    return BasisWithTable{basis, std::move(pieces), std::move(table)};
  });
}

// Returns the enclosure of K V at the coordinate `at` in [0, 1] of a piece.
numerics::Enclosure enclose_mean_after_impulse(const BasisWithTable& t, const Eigen::VectorXd& c,
                                               std::size_t piece, double at) {
  return numerics::call_with_upward_rounding([&] {
    numerics::Interval sum = numerics::symmetric_interval(
        (numerics::Interval(t.table.remainder_bound) * c.cwiseAbs().maxCoeff()).upper());
    for (int b = 0; b < t.basis.size(); ++b) {
      sum += c(b) * evaluate_bernstein_polynomial(
                        t.table.post_impulse_mean_coefficients(static_cast<int>(piece), b),
                        numerics::Interval(at));
    }
    return enclosure_from_interval(sum);
  });
}

double velocity_on_piece(const VelocityAxisPiece& piece, double t) {
  return piece.begin.lower() + t * (piece.end.upper() - piece.begin.lower());
}

// Returns E[V(v + Y)] by Gauss quadrature between all points where the integrand is not smooth,
// plus the sum over atoms.
double mean_after_impulse_by_quadrature(const BasisWithTable& t, const Eigen::VectorXd& c,
                                        const ImpulseLaw& law, double v) {
  double sum = 0;
  for (const problem::AmplitudeAtom& atom : law.amplitude_atoms()) {
    sum += atom.probability * spline_value(t.basis, c, v + atom.amplitude);
  }
  std::vector<double> ends = law.amplitude_density_breakpoints();
  if (ends.empty()) return sum;
  const double first = ends.front(), last = ends.back();
  for (const double u : basis_break_velocities(t.basis))
    ends.push_back(std::clamp(u - v, first, last));
  for (double y = first; y < last; y += kDeviation / 2) ends.push_back(y);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i + 1] - ends[i] < 1e-14) continue;
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double y) { return law.density(y) * spline_value(t.basis, c, v + y); }, ends[i],
        ends[i + 1]);
  }
  return sum;
}

class ImpulseTables : public ::testing::TestWithParam<std::tuple<const char*, double>> {
 protected:
  /// "mirrored": the exponential law with a lower tail.
  ImpulseLaw law() const {
    const auto [name, mean] = GetParam();
    if (std::string_view(name) != "mirrored") return ImpulseLaw::from_name(name, mean, kDeviation);
    return ImpulseLaw::from_name("exponential", mean, kDeviation, {.skewness = -2});
  }
};

TEST_P(ImpulseTables, ReproduceTheMomentsOfTheLawOnPowers) {
  // E[(v + Y)^n] = sum C(n, i) v^(n-i) E[Y^i], far from the ends of the basis.
  const BasisWithTable t = make_basis_with_table(law(), 13, 12, 0.9);
  for (const int n : {0, 1, 2, 3, 6}) {
    const Eigen::VectorXd c = power_coefficients(t.basis, n);
    int checked = 0;
    for (std::size_t p = 0; p < t.pieces.size(); p += 7) {
      const double v = velocity_on_piece(t.pieces[p], 0.4);
      if (std::abs(v) > 1.5) continue;
      double exact = 0;
      for (int i = 0; i <= n; ++i) {
        exact +=
            boost::math::binomial_coefficient<double>(n, i) * std::pow(v, n - i) * law().moment(i);
      }
      const numerics::Enclosure mean = enclose_mean_after_impulse(t, c, p, 0.4);
      // The constants beyond the ends are not powers: exp(-sqrt(2) 10/.31) 13^6 for laplace,
      // exp(-11.5/.31) 13^6 for exponential.
      EXPECT_NEAR(mean.midpoint(), exact, 4e-10) << "power " << n << " at " << v;
      ++checked;
    }
    EXPECT_GE(checked, 2);
  }
}

TEST_P(ImpulseTables, EncloseTheQuadratureOfARoughSpline) {
  const BasisWithTable t = make_basis_with_table(law(), 2.5, 7, 0.6);
  Eigen::VectorXd c(t.basis.size());
  for (int b = 0; b < c.size(); ++b) c(b) = std::cos(2.3 * b * b);
  for (std::size_t p = 0; p < t.pieces.size(); p += 3) {
    for (const double at : {0.0, 0.5, 0.97}) {
      const double v = velocity_on_piece(t.pieces[p], at),
                   expected = mean_after_impulse_by_quadrature(t, c, law(), v);
      const numerics::Enclosure mean = enclose_mean_after_impulse(t, c, p, at);
      EXPECT_NEAR(mean.midpoint(), expected, 3e-11) << "at " << v;
      EXPECT_LT(mean.half_width(), 1e-9);
    }
  }
}

TEST_P(ImpulseTables, MomentsAreThoseOfTheLaw) {
  for (int n = 0; n <= 24; ++n) {
    const numerics::Interval m =
        numerics::call_with_upward_rounding([&] { return enclose_amplitude_moment(law(), n); });
    const double expected = law().moment(n);
    EXPECT_NEAR(m.lower(), expected, 1e-12 * std::abs(expected)) << n;
    EXPECT_NEAR(m.upper(), expected, 1e-12 * std::abs(expected)) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ImpulseTables,
                         ::testing::Combine(::testing::Values("gaussian", "laplace", "two_point",
                                                              "uniform", "exponential", "mirrored"),
                                            ::testing::Values(0.0, 0.17, -0.4)));

TEST(Enclosures, AreThoseOfLawsWithATable) {
  EXPECT_TRUE(has_interval_enclosures(ImpulseLaw::from_name("laplace", 0, 1)));
  const ImpulseLaw gamma = ImpulseLaw::from_name("gamma", 0, 1);
  EXPECT_FALSE(has_interval_enclosures(gamma));
  EXPECT_THROW(enclose_amplitude_moment(gamma, 2), std::logic_error);
}

}  // namespace
}  // namespace fpkcheck::backward
