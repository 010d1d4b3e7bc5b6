#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

// All coefficients of (22) are significant: impact losses, and comparable E[Y], E[Y^3] and E[Y^4].
problem::Problem skewed_problem() {
  return tests::make_problem({.damping = 0.3,
                              .stiffness = 0.7,
                              .cubic = 0.4,
                              .restitution = 0.6,
                              .rate = 0.8,
                              .intensity = 0.9,
                              .mean = 0.5});
}

ProjectedEquations make_projection(const problem::Problem& problem, int order, MonomialSet set) {
  return ProjectedEquations(GaussianWeightedBasis(order, set, gaussian_weight_deviations(problem)));
}

Eigen::VectorXd random_coefficients(Eigen::Index size, double scale) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal(0, scale);
  return Eigen::VectorXd::NullaryExpr(size, [&](Eigen::Index) { return normal(generator); });
}

// Evaluates the residual (20) from exp(Q) and from derivatives of exp(Q) by Cauchy's integral,
// independently of (22).
class DirectEvaluation {
 public:
  using Complex = std::complex<double>;

  /// @param force g(y), y >= 0
  DirectEvaluation(const problem::Problem& problem, const numerics::Polynomial& force,
                   DensityEquation equation, ExponentPolynomial q)
      : problem_(problem),
        force_(force),
        higher_(equation == DensityEquation::km4),
        q_(std::move(q)) {}

  /// Delta / p~ of (20) without the term of the delta function.
  double plain(double x1, double x2) const {
    // All values are relative to the density at the point, which may be very small.
    const Complex here = exponent(x1, x2);
    const auto at_x1 = [&](Complex z) { return std::exp(exponent(z, x2) - here); };
    const auto at_x2 = [&](Complex z) { return std::exp(exponent(x1, z) - here); };
    const double sgn = x1 > 0 ? 1 : -1;
    const auto drift = [&](Complex z) {
      return (problem_.system.damping() * z + sgn * force_(std::abs(x1))) * at_x2(z);
    };
    const auto& train = problem_.impulses;
    double delta = -x2 * derivative(at_x1, x1, 1) + derivative(drift, x2, 1) -
                   sgn * train.rate_times_moment(1) * derivative(at_x2, x2, 1) +
                   train.rate_times_moment(2) / 2 * derivative(at_x2, x2, 2);
    if (higher_) {
      delta += -sgn * train.rate_times_moment(3) / 6 * derivative(at_x2, x2, 3) +
               train.rate_times_moment(4) / 24 * derivative(at_x2, x2, 4);
    }
    return delta;
  }

  /// The factor of delta(x1) in Delta / p~.
  double at_wall(double x2) const {
    const auto flux = [&](double z) {
      return z * std::abs(z) * std::exp(exponent(0, z) - exponent(0, x2)).real();
    };
    const double h = 1e-5;
    return (1 - problem_.system.restitution()) * (flux(x2 + h) - flux(x2 - h)) / (2 * h);
  }

 private:
  Complex exponent(Complex x1, Complex x2) const {
    Complex q = 0;
    for (const auto& [i, j, a] : q_.terms()) q += a * std::pow(x1, i) * std::pow(x2, j);
    return q;
  }

  // j-th derivative of an entire function: j! / rho^j times the j-th Fourier coefficient on a
  // circle.
  template <class Function>
  static double derivative(const Function& f, double x, int j) {
    constexpr int kPoints = 48;
    constexpr double kRadius = 0.2;
    Complex sum = 0;
    for (int k = 0; k < kPoints; ++k) {
      const double phi = 2 * std::numbers::pi * k / kPoints;
      sum += f(x + std::polar(kRadius, phi)) * std::polar(1.0, -j * phi);
    }
    return std::tgamma(j + 1) / std::pow(kRadius, j) * sum.real() / kPoints;
  }

  problem::Problem problem_;
  numerics::Polynomial force_;
  bool higher_;
  ExponentPolynomial q_;
};

double normal_density(double x, double sigma) {
  return std::exp(-x * x / (2 * sigma * sigma)) / (std::sqrt(2 * std::numbers::pi) * sigma);
}

// Returns the projections (23) by quadrature on panels over the four quadrants and along the wall.
Eigen::VectorXd directly_evaluated_residual(const DirectEvaluation& brute,
                                            const GaussianWeightedBasis& basis) {
  constexpr int kPanels = 4;
  const double s1 = basis.weight_standard_deviations().x1,
               s2 = basis.weight_standard_deviations().x2;
  const double far = 11;
  const auto both_halves = [&](const auto& g, double sigma) -> Eigen::VectorXd {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(basis.size());
    const double width = far * sigma / kPanels;
    for (int k = -kPanels; k < kPanels; ++k) {
      using Gauss = boost::math::quadrature::gauss<double, 10>;
      for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
        for (const int side : {-1, 1}) {
          const double x = width * (k + 0.5 * (1 + side * Gauss::abscissa()[i]));
          sum += Gauss::weights()[i] * width / 2 * g(x);
        }
      }
    }
    return sum;
  };
  const auto tests = [&](double x1, double x2) -> Eigen::VectorXd {
    return basis.basis_values(Eigen::VectorXd::Constant(1, x1), Eigen::VectorXd::Constant(1, x2))
        .row(0);
  };
  const auto over_x2 = [&](double x1) {
    return both_halves(
        [&](double x2) -> Eigen::VectorXd {
          return brute.plain(x1, x2) * normal_density(x1, s1) * normal_density(x2, s2) *
                 tests(x1, x2);
        },
        s2);
  };
  const auto along_wall = [&](double x2) -> Eigen::VectorXd {
    return brute.at_wall(x2) * normal_density(0, s1) * normal_density(x2, s2) * tests(0, x2);
  };
  return both_halves(over_x2, s1) + both_halves(along_wall, s2);
}

class ProjectionOf : public testing::TestWithParam<std::tuple<MonomialSet, DensityEquation>> {};

TEST_P(ProjectionOf, EquationTwentyTwoEqualsBruteForceFromEquationTwenty) {
  const auto [set, equation] = GetParam();
  const problem::Problem problem = skewed_problem();
  const ProjectedEquations projection = make_projection(problem, 4, set);
  Eigen::VectorXd a = random_coefficients(projection.basis().size(), 0.05);
  a += projection.basis().scaled_coefficients({{2, 0, -0.5}, {0, 2, -0.4}});
  const Eigen::VectorXd expected = directly_evaluated_residual(
      DirectEvaluation(problem, problem.system.restoring_force(), equation,
                       projection.basis().exponent_polynomial(a)),
      projection.basis());
  const Eigen::VectorXd residual = projection.residual(residual_coefficients(problem, equation), a);
  EXPECT_GT(expected.norm(), 0.1);
  for (Eigen::Index s = 0; s < residual.size(); ++s) {
    EXPECT_NEAR(residual[s], expected[s], 1e-8 * expected.norm()) << "projection " << s;
  }
}

TEST_P(ProjectionOf, JacobianIsTheDerivativeOfTheResidual) {
  const auto [set, equation] = GetParam();
  const problem::Problem problem = skewed_problem();
  const ProjectedEquations projection = make_projection(problem, 6, set);
  const DensityEquationCoefficients f = residual_coefficients(problem, equation);
  const Eigen::VectorXd a = random_coefficients(projection.basis().size(), 0.1);
  const Eigen::MatrixXd jacobian = projection.jacobian(f, a);
  const double h = 1e-4;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(a.size(), k) * h;
    // Central differences with one Richardson step: exact, since F is of fourth degree in a.
    const auto difference = [&](double m) -> Eigen::VectorXd {
      return (projection.residual(f, a + m * e) - projection.residual(f, a - m * e)) / (2 * m * h);
    };
    const Eigen::VectorXd expected = (4 * difference(1) - difference(2)) / 3;
    EXPECT_LT((jacobian.col(k) - expected).norm(), 1e-8 * jacobian.norm()) << "unknown " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllForms, ProjectionOf,
    testing::Combine(testing::Values(MonomialSet::point_symmetric, MonomialSet::general),
                     testing::Values(DensityEquation::white, DensityEquation::km4)));

// A spring with all powers up to the fifth: even powers have the factor sgn(x1) on the plane.
TEST(ProjectedEquations, TakesEveryPowerOfTheSpring) {
  const problem::Problem problem = skewed_problem();
  const numerics::Polynomial even({0, 0, 0.3, 0, -0.05}), odd({0, 0.7, 0, 0.4, 0, 0.02}),
      force({0, 0.7, 0.3, 0.4, -0.05, 0.02});
  DensityEquationCoefficients f = residual_coefficients(problem, DensityEquation::km4);
  f.even_force = even;
  f.odd_force = odd;
  for (const int order : {2, 4}) {
    for (const MonomialSet set : {MonomialSet::point_symmetric, MonomialSet::general}) {
      const ProjectedEquations projection = make_projection(problem, order, set);
      Eigen::VectorXd a = random_coefficients(projection.basis().size(), 0.05);
      a += projection.basis().scaled_coefficients({{2, 0, -0.5}, {0, 2, -0.4}});
      const Eigen::VectorXd expected =
          directly_evaluated_residual(DirectEvaluation(problem, force, DensityEquation::km4,
                                                       projection.basis().exponent_polynomial(a)),
                                      projection.basis());
      const Eigen::VectorXd residual = projection.residual(f, a);
      EXPECT_LT((residual - expected).norm(), 1e-8 * expected.norm()) << "n " << order;
      // The difference is exact for F, which is of fourth degree in a.
      const Eigen::VectorXd e = random_coefficients(a.size(), 1e-2);
      const auto difference = [&](double m) -> Eigen::VectorXd {
        return (projection.residual(f, a + m * e) - projection.residual(f, a - m * e)) / (2 * m);
      };
      const Eigen::VectorXd slope = (4 * difference(1) - difference(2)) / 3;
      EXPECT_LT((projection.jacobian(f, a) * e - slope).norm(), 1e-10 * slope.norm());
    }
  }
}

TEST(ProjectedEquations, SplitsTheForceByTheParityOfItsPowers) {
  const problem::Problem problem = skewed_problem();
  const DensityEquationCoefficients f = residual_coefficients(problem, DensityEquation::km4);
  EXPECT_EQ(f.odd_force.coefficients(), problem.system.restoring_force().coefficients());
  EXPECT_EQ(f.even_force.coefficients(), numerics::Polynomial::Coefficients{});
}

TEST(ProjectedEquations, OddProjectionsOfAPointSymmetricPolynomialVanish) {
  const problem::Problem problem = skewed_problem();
  const ProjectedEquations half = make_projection(problem, 6, MonomialSet::point_symmetric);
  const ProjectedEquations whole = make_projection(problem, 6, MonomialSet::general);
  const DensityEquationCoefficients f = residual_coefficients(problem, DensityEquation::km4);
  const Eigen::VectorXd a = random_coefficients(half.basis().size(), 0.1);
  const Eigen::VectorXd small = half.residual(f, a);
  const Eigen::VectorXd large = whole.residual(
      f, whole.basis().scaled_coefficients(half.basis().exponent_polynomial(a).terms()));
  ASSERT_EQ(half.basis().size(), 15);
  ASSERT_EQ(whole.basis().size(), 27);
  EXPECT_NEAR(large.norm(), small.norm(), 1e-12 * small.norm());
  Eigen::Index at_small = 0, at_large = 0;
  for (int m = 1; m <= 6; ++m) {
    for (int l = 0; l <= m; ++l, ++at_large) {
      const double expected = m % 2 == 0 ? small[at_small++] : 0;
      EXPECT_NEAR(large[at_large], expected, 1e-12 * small.norm());
    }
  }
}

TEST(ProjectedEquations, VanishesAtTheExactWhiteNoiseDensity) {
  const problem::Problem problem = tests::make_problem({.cubic = 0.5, .restitution = 1});
  const double beta = 0.1 / (0.1 / 2);
  for (const int order : {4, 6, 8, 12}) {
    const ProjectedEquations projection = make_projection(problem, order, MonomialSet::general);
    const Eigen::VectorXd a = projection.basis().scaled_coefficients(
        {{2, 0, -beta / 2}, {0, 2, -beta / 2}, {4, 0, -beta * 0.5 / 4}});
    EXPECT_LT(projection.residual(residual_coefficients(problem, DensityEquation::white), a).norm(),
              1e-13);
  }
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
