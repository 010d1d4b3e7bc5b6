#include "fd_fpk/axis/axis_operators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

Eigen::VectorXd monomial_averages(const GridAxis& axis, int power) {
  Eigen::VectorXd averages(axis.cell_count());
  for (int i = 0; i < axis.cell_count(); ++i) {
    averages(i) = (std::pow(axis.face_position(i + 1), power + 1) -
                   std::pow(axis.face_position(i), power + 1)) /
                  ((power + 1) * axis.cell_width(i));
  }
  return averages;
}

// Cells of unequal width, with ratios of neighbouring widths up to 4/3.
const GridAxis kLine({-0.3, -0.2, -0.08, 0.05, 0.15, 0.27, 0.4, 0.56, 0.7, 0.8, 0.93, 1.08, 1.2,
                      1.3, 1.42},
                     AxisEndCondition::boundary);

// Rows whose stencil extends beyond the right end use p = 0 there and are not exact.
int last_exact_face(int points) { return kLine.cell_count() - points; }

TEST(AxisOperators, FaceValuesAndSlopesAreExactOnPolynomialsUpToTheLeftBoundary) {
  for (int points = 2; points <= 8; ++points) {
    for (int power = 0; power < points; ++power) {
      const auto averages = monomial_averages(kLine, power);
      for (const UpstreamSideOfFace bias : {UpstreamSideOfFace::left, UpstreamSideOfFace::right}) {
        const Eigen::VectorXd values = face_value_operator(kLine, points, bias) * averages;
        for (int f = 1; f <= last_exact_face(points); ++f) {
          EXPECT_NEAR(values(f), std::pow(kLine.face_position(f), power), 1e-11)
              << points << " " << power;
        }
      }
      if (points % 2 == 0) {
        const Eigen::VectorXd slopes = face_derivative_operator(kLine, points) * averages;
        for (int f = 1; f <= last_exact_face(points); ++f) {
          EXPECT_NEAR(slopes(f),
                      power == 0 ? 0 : power * std::pow(kLine.face_position(f), power - 1), 1e-9);
        }
      }
      EXPECT_NEAR((end_value_operator(kLine, AxisEnd::left, points) * averages)(0),
                  std::pow(kLine.face_position(0), power), 1e-11);
    }
  }
}

// Zero flux f p + p' with f = b - a for x < 0, b + a for x > 0 (D = 1): p = exp(-b x - a |x|). A
// constant flux 1 has the solution p = (1 - exp(-f x))/f. Both have a kink at x = 0.
TEST(AxisOperators, AKinkIsReconstructedWithSecondOrderFluxes) {
  constexpr double kDecay = 2, kDrift = 0.7;
  const auto force = [&](double x) { return kDrift + (x < 0 ? -kDecay : kDecay); };
  const auto flux_error = [&](int cells, bool has_flux) {
    const GridAxis axis = GridAxis::with_uniform_cells(-2, 4.0 / cells, cells);
    Eigen::VectorXd averages(cells);
    for (int i = 0; i < cells; ++i) {
      const double f = force(axis.cell_centre(i)), width = axis.cell_width(i);
      const double exponentials =
          (std::exp(-f * axis.face_position(i)) - std::exp(-f * axis.face_position(i + 1))) /
          (f * width);
      averages(i) = has_flux ? (1 - exponentials) / f : exponentials;
    }
    const DensityKink kink{.decay = kDecay, .drift = kDrift};
    const Eigen::VectorXd value =
        face_value_operator(axis, 8, UpstreamSideOfFace::left, kink) * averages;
    const Eigen::VectorXd slope = face_derivative_operator(axis, 8, kink) * averages;
    double worst = 0;
    for (int f = 8; f <= cells - 8; ++f) {
      const double x = axis.face_position(f);
      const double flux = (f == cells / 2 ? kDrift : force(x)) * value(f) + slope(f);
      worst = std::max(worst, std::abs(flux - (has_flux ? 1 : 0)));
    }
    return worst;
  };
  for (const bool has_flux : {false, true}) {
    const double coarse = flux_error(64, has_flux), fine = flux_error(128, has_flux);
    EXPECT_LT(fine, 1e-3) << has_flux;
    EXPECT_GT(std::log2(coarse / fine), 1.9) << has_flux;
  }
}

TEST(AxisOperators, OddStencilsTakeTheExtraCellFromTheirBias) {
  const AxisOperator left = face_value_operator(kLine, 3, UpstreamSideOfFace::left);
  const AxisOperator right = face_value_operator(kLine, 3, UpstreamSideOfFace::right);
  EXPECT_NE(left.coeff(6, 4), 0.0);
  EXPECT_EQ(left.coeff(6, 7), 0.0);
  EXPECT_EQ(right.coeff(6, 4), 0.0);
  EXPECT_NE(right.coeff(6, 7), 0.0);
}

TEST(AxisOperators, NothingFlowsThroughTheEndFaces) {
  const AxisOperator values = face_value_operator(kLine, 5, UpstreamSideOfFace::left);
  EXPECT_EQ(values.row(0).norm(), 0.0);
  EXPECT_EQ(values.row(kLine.cell_count()).norm(), 0.0);
}

TEST(AxisOperators, WeightedAveragesAreExactForPolynomialsOnBothSidesOfABarrier) {
  const numerics::Polynomial weight({0.3, -1.0, 0.5, 2.0, 0.0, 0.7});
  const int barrier = 7;
  for (const int points : {1, 3, 5}) {
    const AxisOperator op = weighted_average_operator(kLine, points, weight, barrier);
    for (int power = 0; power < points; ++power) {
      const Eigen::VectorXd weighted = op * monomial_averages(kLine, power);
      Eigen::VectorXd exact = Eigen::VectorXd::Zero(kLine.cell_count());
      for (int q = 0; q <= 5; ++q) {
        exact += weight.coefficient(q) * monomial_averages(kLine, power + q);
      }
      for (int i = 0; i < kLine.cell_count() - points / 2; ++i) {
        EXPECT_NEAR(weighted(i), exact(i), 1e-12) << points << " " << power << " " << i;
      }
    }
    EXPECT_EQ(op.block(0, barrier, barrier, kLine.cell_count() - barrier).norm(), 0.0);
    EXPECT_EQ(op.block(barrier, 0, kLine.cell_count() - barrier, barrier).norm(), 0.0);
  }
}

TEST(AxisOperators, WeightedAveragesOfAFunctionAreThoseOfAPolynomial) {
  const numerics::Polynomial weight({0.3, -1.0, 0.5, 2.0, 0.0, 0.7});
  for (const int points : {1, 3, 5}) {
    const WeightedAverageMatrixBuilder averages(kLine, points);
    EXPECT_LT((averages.weighted_average_matrix([&](double x) { return weight(x); }) -
               weighted_average_operator(kLine, points, weight))
                  .norm(),
              1e-11)
        << points;
    EXPECT_EQ(averages.weighted_average_matrix([](double) { return 0.0; }).nonZeros(), 0) << points;
  }
}

TEST(AxisOperators, WeightedAveragesGainOneOrderOverTheirStencil) {
  // avg(x^3 cos x) from averages of cos x with three cells: order 4.
  const auto error = [](int cells) {
    const GridAxis axis =
        GridAxis::with_uniform_cells(0.2, 1.0 / cells, cells, AxisEndCondition::boundary);
    Eigen::VectorXd averages(cells);
    for (int i = 0; i < cells; ++i) {
      averages(i) = (std::sin(axis.face_position(i + 1)) - std::sin(axis.face_position(i))) /
                    axis.cell_width(i);
    }
    const auto primitive = [](double x) {  // primitive of x^3 cos x
      return x * x * x * std::sin(x) + 3 * x * x * std::cos(x) - 6 * x * std::sin(x) -
             6 * std::cos(x);
    };
    const Eigen::VectorXd weighted =
        weighted_average_operator(axis, 3, numerics::Polynomial({0, 0, 0, 1})) * averages;
    double largest = 0;
    for (int i = 0; i < cells - 1; ++i) {
      const double exact =
          (primitive(axis.face_position(i + 1)) - primitive(axis.face_position(i))) /
          axis.cell_width(i);
      largest = std::max(largest, std::abs(weighted(i) - exact));
    }
    return largest;
  };
  const double coarse = error(20), middle = error(40), fine = error(80);
  for (const double order : {std::log2(coarse / middle), std::log2(middle / fine)}) {
    EXPECT_GT(order, 3.7) << coarse << " " << middle << " " << fine;
    EXPECT_LT(order, 4.3) << coarse << " " << middle << " " << fine;
  }
}

TEST(AxisOperators, DivergenceTelescopes) {
  const AxisOperator div = divergence_operator(kLine);
  const Eigen::VectorXd flux =
      Eigen::VectorXd::LinSpaced(kLine.cell_count() + 1, 1, 7).array().exp();
  EXPECT_NEAR(kLine.cell_widths().dot(div * flux), flux(kLine.cell_count()) - flux(0), 1e-9);
  EXPECT_NEAR((div * flux)(3), (flux(4) - flux(3)) / kLine.cell_width(3), 1e-12);
}

TEST(AxisOperators, StencilsStayWithinABoundaryOnTheRight) {
  const GridAxis axis({0, 0.4, 0.9, 1.3, 1.8, 2.2, 2.5, 3.0, 3.2}, AxisEndCondition::vacuum,
                      AxisEndCondition::boundary);
  const int cells = axis.cell_count(), degree = 4;
  const Eigen::VectorXd p = monomial_averages(axis, degree);
  EXPECT_NEAR((end_value_operator(axis, AxisEnd::right, degree + 1) * p)(0), std::pow(3.2, degree),
              1e-10);
  const Eigen::VectorXd times_x =
      weighted_average_operator(axis, degree + 1, numerics::Polynomial({0, 1})) * p;
  const Eigen::VectorXd exact = monomial_averages(axis, degree + 1);
  for (const UpstreamSideOfFace bias : {UpstreamSideOfFace::left, UpstreamSideOfFace::right}) {
    const Eigen::VectorXd values = face_value_operator(axis, degree + 1, bias) * p;
    for (int f = 4; f < cells; ++f) {  // stencils of the other cells extend into the vacuum
      EXPECT_NEAR(values(f), std::pow(axis.face_position(f), degree), 1e-10) << f;
      EXPECT_NEAR(times_x(f), exact(f), 1e-10) << f;
    }
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
