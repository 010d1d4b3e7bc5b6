#include <gtest/gtest.h>

#include <cmath>

#include "backward/generator/impact_basis.hpp"
#include "spline_coefficients.hpp"

namespace fpkcheck::backward {
namespace {

ImpactSplineBasis make_example_basis(double r = 0.7) {
  return ImpactSplineBasis(numerics::SplineBasis(numerics::graded_break_points(3, 6, 0.1, 1)), r);
}

TEST(VelocityPieces, CoverTheRangeAndEndAtBreaksAndCuts) {
  const ImpactSplineBasis basis = make_example_basis();
  const std::vector<VelocityAxisPiece> pieces = numerics::call_with_upward_rounding([&] {
    return divide_velocity_axis(basis, std::array{-1.234, 0.5}, 0.3);
  });
  EXPECT_EQ(pieces.front().begin.lower(), -3);
  EXPECT_NEAR(pieces.back().end.upper(), 0.7 * 3, 1e-15);
  std::vector<double> expected_ends = basis_break_velocities(basis);
  expected_ends.insert(expected_ends.end(), {-1.234, 0.5});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_LT(pieces[i].end.upper() - pieces[i].begin.lower(), 0.3 + 1e-12);
    if (i == 0) continue;
    EXPECT_EQ(pieces[i].begin.lower(), pieces[i - 1].end.lower());
  }
  for (const double v : expected_ends) {
    double nearest = 1;
    for (const VelocityAxisPiece& p : pieces) {
      nearest = std::min({nearest, std::abs(p.begin.lower() - v), std::abs(p.end.lower() - v)});
    }
    EXPECT_LT(nearest, 1e-15) << v;
  }
}

TEST(VelocityPieces, FunctionsAreThoseOfTheBasisOnBothSides) {
  const ImpactSplineBasis basis = make_example_basis();
  numerics::call_with_upward_rounding([&] {
    for (const VelocityAxisPiece& piece :
         divide_velocity_axis(basis, std::array{-0.9, 0.4}, 0.25)) {
      const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, piece);
      for (std::size_t l = 0; l < functions.indices.size(); ++l) {
        Eigen::VectorXd c = Eigen::VectorXd::Zero(basis.size());
        c(functions.indices[l]) = 1;
        for (const double t : {0.0, 0.4, 1.0}) {
          const double v = piece.begin.lower() + t * (piece.end.lower() - piece.begin.lower());
          const double expected = spline_value(basis, c, v);
          EXPECT_NEAR(evaluate_bernstein_polynomial(functions.polynomials[l], numerics::Interval(t))
                          .lower(),
                      expected, 1e-12);
        }
      }
    }
    return 0;
  });
}

TEST(VelocityPieces, MirroredFunctionsSatisfyTheImpactCondition) {
  // The impact condition in exact arithmetic: the enclosures of the Bernstein coefficients on
  // mirrored spans overlap, even if r u is rounded.
  const ImpactSplineBasis basis = make_example_basis(0.98);
  numerics::call_with_upward_rounding([&] {
    const std::vector<VelocityAxisPiece> spans = divide_velocity_axis(basis, {}, 100);
    for (std::size_t i = 0; i < spans.size() / 2; ++i) {
      const BasisFunctionsOnVelocityPiece in = basis_functions_on_piece(basis, spans[i]);
      const BasisFunctionsOnVelocityPiece out =
          basis_functions_on_piece(basis, spans[spans.size() - 1 - i]);
      for (std::size_t l = 0; l < in.indices.size(); ++l) {
        EXPECT_EQ(out.indices[l], basis.basis_index_after_impact(in.indices[l]));
        for (std::size_t j = 0; j < in.polynomials[l].size(); ++j) {
          EXPECT_TRUE(
              overlap(in.polynomials[l][j], out.polynomials[l][in.polynomials[l].size() - 1 - j]));
        }
      }
    }
    return 0;
  });
}

TEST(VelocityPieces, SlopesOfDifferencesAddUpToTheDerivative) {
  const ImpactSplineBasis basis = make_example_basis();
  const Eigen::VectorXd c = power_coefficients(basis, 3);
  numerics::call_with_upward_rounding([&] {
    for (const VelocityAxisPiece& piece : divide_velocity_axis(basis, {}, 0.5)) {
      const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, piece);
      const std::vector<numerics::BernsteinCoefficients> slopes =
          enclose_slopes_of_basis_partial_sums(basis, piece);
      numerics::Interval slope = 0;
      for (std::size_t l = 1; l < functions.indices.size(); ++l) {
        slope += (numerics::Interval(c(functions.indices[l])) - c(functions.indices[l - 1])) *
                 evaluate_bernstein_polynomial(slopes[l - 1], numerics::Interval(0.5));
      }
      const double v = ((piece.begin + piece.end) / 2.0).lower();
      EXPECT_NEAR(slope.lower(), 3 * v * v, 1e-11);
      EXPECT_LT(width(slope), 1e-10);
    }
    return 0;
  });
}

TEST(VelocityPieces, OverhangIsPartOfTheError) {
  const ImpactSplineBasis basis = make_example_basis();
  numerics::call_with_upward_rounding([&] {
    const VelocityAxisPiece across =
        make_velocity_piece(basis, numerics::Interval(-0.5), numerics::Interval(1e-3));
    EXPECT_EQ(across.side, VelocityAxisPart::incoming);
    EXPECT_GE(across.rounding_overhang, 1e-3);
    const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, across);
    // On the overhang the polynomial of the central function exceeds 1, but the function itself
    // decreases.
    Eigen::VectorXd c = Eigen::VectorXd::Zero(basis.size());
    c(basis.basis_index_at_zero_velocity()) = 1;
    for (std::size_t l = 0; l < functions.indices.size(); ++l) {
      if (functions.indices[l] != basis.basis_index_at_zero_velocity()) continue;
      const double polynomial_value =
          evaluate_bernstein_polynomial(functions.polynomials[l], numerics::Interval(1)).upper();
      const double error = std::abs(polynomial_value - spline_value(basis, c, 1e-3));
      EXPECT_GT(error, 1e-4);
      EXPECT_LE(error, functions.overhang_error);
    }
    const VelocityAxisPiece inside =
        make_velocity_piece(basis, numerics::Interval(-0.06), numerics::Interval(-0.05));
    EXPECT_EQ(basis_functions_on_piece(basis, inside).overhang_error, 0);
    return 0;
  });
}

}  // namespace
}  // namespace fpkcheck::backward
