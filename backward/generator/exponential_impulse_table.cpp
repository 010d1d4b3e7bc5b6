// The Laplace law of the impulse Y has the density exp(-|y - m|/s) / (2s) with the mean m and the
// scale s. The mean of a spline B after an impulse is K B(v) = L(v + m) + R(v + m) with
//
//     L(z) = int_{-inf}^z B(x) exp(-(z - x)/s) dx/(2s),   s L' = -L + B/2,
//
// and R is the mirrored integral over x > z. For the exponential law the mean K B(v) after an
// impulse is only one of the integrals L and R, with the weight w = 1 in place of 1/2. The mean of
// a spline after an impulse is R(v + m - s) for an upper tail of the law, and L(v + m + s) for a
// lower tail, with the integrals L and R.
//
// The integral L is computed from piece to piece along the velocity axis. Let e be the length of a
// piece of the velocity axis, and theta = (z - begin)/e the position z on this piece. On a piece
// the integral L is the sum of two solutions of s L' = -L + w B: the homogeneous solution L(begin)
// exp(-e theta/s), and the solution that is 0 at theta = 0. Both solutions are power series in
// theta, whose coefficients q_n satisfy
//
//     q_{n+1} = (e/s) (-q_n + w b_n) / (n + 1)
//
// with the power series coefficients b_n of B. For n above the degree p of the spline B, the terms
// of the power series are those of an exponential series: the remainder after the term n = N - 1 is
// at most |q_N| exp(e/s).
#include <algorithm>
#include <cmath>

#include "backward/generator/impulse_mean_table.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kSeriesTerms = 16;  // number N of terms of the power series

// Enclosed Bernstein coefficients of the solutions of s L' = -L + w B on a piece of the v axis.
struct OdeSolutionsOnVelocityPiece {
  numerics::BernsteinCoefficients homogeneous;  // exp(-e theta/s)
  // Solution of s L' = -L + w B that is 0 at the beginning of the piece (theta = 0), for each
  // spline B of the piece
  std::vector<numerics::BernsteinCoefficients> particular;
  numerics::Interval decay;  // factor exp(-e/s) of the homogeneous solution over the whole piece
};

// Returns enclosed Bernstein coefficients of a power series, from its first N coefficients q_n and
// the next coefficient q_N.
// @param ratio length e of the piece divided by the scale s of the law
numerics::BernsteinCoefficients enclose_series(numerics::BernsteinCoefficients powers,
                                               const numerics::Interval& next,
                                               const numerics::Interval& ratio) {
  const numerics::Interval growth = 1.0 / exponential(-ratio);
  const double remainder = (magnitude(next) * growth).upper();
  numerics::BernsteinCoefficients b = bernstein_from_power_coefficients(powers);
  for (numerics::Interval& c : b) c += numerics::symmetric_interval(remainder);
  return b;
}

OdeSolutionsOnVelocityPiece solve_on_piece(
    const std::vector<numerics::BernsteinCoefficients>& functions, const numerics::Interval& length,
    double s, double weight) {
  const numerics::Interval ratio = length / s;
  OdeSolutionsOnVelocityPiece solutions;
  solutions.decay = exponential(-ratio);
  const auto series = [&](const numerics::BernsteinCoefficients& forcing,
                          const numerics::Interval& start) {
    numerics::BernsteinCoefficients q(kSeriesTerms);
    numerics::Interval next = start;
    for (int n = 0; n < kSeriesTerms; ++n) {
      q[n] = next;
      const numerics::Interval b =
          n < static_cast<int>(forcing.size()) ? forcing[n] : numerics::Interval(0);
      next = ratio * (weight * b - q[n]) / static_cast<double>(n + 1);
    }
    return enclose_series(std::move(q), next, ratio);
  };
  solutions.homogeneous = series({}, numerics::Interval(1));
  for (const numerics::BernsteinCoefficients& b : functions) {
    solutions.particular.push_back(
        series(power_coefficients_from_bernstein(b), numerics::Interval(0)));
  }
  return solutions;
}

// Pieces of the velocity axis shifted by the offset of the law, in increasing order. Additional
// pieces lie between the shifted pieces and the ends of the splines of v.
struct ShiftedVelocityPieces {
  std::vector<VelocityAxisPiece> pieces;
  std::size_t first_index = 0;  // index of the first shifted piece, after the additional pieces
};

ShiftedVelocityPieces shift_pieces(const ImpactSplineBasis& basis,
                                   const std::vector<VelocityAxisPiece>& pieces,
                                   const numerics::Interval& shift, double longest) {
  ShiftedVelocityPieces shifted;
  const numerics::Interval begin = pieces.front().begin + shift, end = pieces.back().end + shift;
  const auto add_pieces_between = [&](const numerics::Interval& from,
                                      const numerics::Interval& to) {
    for (const VelocityAxisPiece& p : divide_velocity_axis(basis, {}, longest)) {
      if (p.end.upper() <= from.lower() || p.begin.lower() >= to.upper()) continue;
      const numerics::Interval a = p.begin.lower() < from.lower() ? from : p.begin;
      const numerics::Interval b = p.end.upper() > to.upper() ? to : p.end;
      shifted.pieces.push_back(make_velocity_piece(basis, a, b));
    }
  };
  if (shift.lower() > 0) add_pieces_between(pieces.front().begin, begin);
  shifted.first_index = shifted.pieces.size();
  for (const VelocityAxisPiece& p : pieces) {
    shifted.pieces.push_back(make_velocity_piece(basis, p.begin + shift, p.end + shift));
  }
  if (shift.upper() < 0) add_pieces_between(end, pieces.back().end);
  return shifted;
}

// Weights w of the integral L over velocities below z and of the integral R above z.
struct OneSidedIntegralWeights {
  double below, above;
};

// Makes the table of the means after an impulse for a law with exponential tails of the scale s.
PostImpulseMeanTable make_exponential_tail_table(const numerics::Interval& shift, double s,
                                                 const OneSidedIntegralWeights& weights,
                                                 const ImpactSplineBasis& basis,
                                                 const std::vector<VelocityAxisPiece>& pieces) {
  PostImpulseMeanTable table = make_zero_impulse_mean_table(basis, pieces, kSeriesTerms);
  double longest = 0, overhang = 0;
  for (const VelocityAxisPiece& piece : pieces) longest = std::max(longest, piece.length().upper());
  const ShiftedVelocityPieces shifted = shift_pieces(basis, pieces, shift, longest);
  const int count = static_cast<int>(shifted.pieces.size());

  for (const bool forward : {true, false}) {
    const double weight = forward ? weights.below : weights.above;
    if (weight == 0) continue;
    // Values of the integral L at the lower end of the velocity axis, or of the integral R at the
    // upper end, for all splines. Beyond the ends of the splines of v every spline is constant.
    std::vector<numerics::Interval> end_values(basis.size(), numerics::Interval(0));
    end_values[forward ? 0 : basis.size() - 1] = weight;
    for (int step = 0; step < count; ++step) {
      const int i = forward ? step : count - 1 - step;
      const VelocityAxisPiece& piece = shifted.pieces[i];
      BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, piece);
      overhang = std::max(overhang, functions.overhang_error);
      if (!forward) {
        for (numerics::BernsteinCoefficients& b : functions.polynomials)
          std::reverse(b.begin(), b.end());
      }
      const OdeSolutionsOnVelocityPiece solutions =
          solve_on_piece(functions.polynomials, piece.length(), s, weight);
      const int target = i - static_cast<int>(shifted.first_index);
      if (target >= 0 && target < static_cast<int>(pieces.size())) {
        const auto add = [&](int b, const numerics::Interval& factor,
                             const numerics::BernsteinCoefficients& c) {
          const std::span<numerics::Interval> out = table.post_impulse_mean_coefficients(target, b);
          for (int j = 0; j < kSeriesTerms; ++j) {
            out[j] += factor * c[forward ? j : kSeriesTerms - 1 - j];
          }
        };
        for (int b = 0; b < basis.size(); ++b) add(b, end_values[b], solutions.homogeneous);
        for (std::size_t l = 0; l < functions.indices.size(); ++l) {
          add(functions.indices[l], numerics::Interval(1), solutions.particular[l]);
        }
      }
      for (numerics::Interval& c : end_values) c *= solutions.decay;
      for (std::size_t l = 0; l < functions.indices.size(); ++l) {
        end_values[functions.indices[l]] += solutions.particular[l].back();
      }
    }
  }
  // A bound of the error of a spline B on the whole velocity axis also bounds the error of its mean
  // K B after an impulse.
  table.remainder_bound =
      (2.0 * (basis.speed_basis().degree() + 1.0) * numerics::Interval(overhang)).upper();
  // If all shifted pieces of the velocity axis are beyond the range of the splines of v, no pieces
  // connect the shifted pieces with this range, and no bound is valid.
  const double range_length = (pieces.back().end - pieces.front().begin).lower();
  if (!(magnitude(shift) < range_length)) table.remainder_bound = HUGE_VAL;
  return table;
}

}  // namespace

PostImpulseMeanTable tabulate_impulse_means(const problem::LaplaceLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces) {
  return make_exponential_tail_table(law.mean, law.scale, {0.5, 0.5}, basis, pieces);
}

PostImpulseMeanTable tabulate_impulse_means(const problem::ExponentialLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces) {
  const numerics::Interval start = numerics::Interval(law.mean) - law.scale;
  return make_exponential_tail_table(
      start, std::abs(law.scale),
      law.scale > 0 ? OneSidedIntegralWeights{0, 1} : OneSidedIntegralWeights{1, 0}, basis, pieces);
}

}  // namespace fpkcheck::backward
