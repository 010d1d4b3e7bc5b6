// The Laplace law has the density exp(-|y - m|/s) / (2s) with the scale s. The mean after an
// impulse is K B(v) = L(v + m) + R(v + m) with
//
//     L(z) = int_{-inf}^z B(x) exp(-(z - x)/s) dx/(2s),   s L' = -L + B/2,
//
// and R the mirrored integral over x > z. The exponential law has only one of the integrals L and
// R, at v + m - scale and with the weight w = 1 in place of 1/2: R for an upper tail, L for a lower
// tail.
//
// L is integrated from piece to piece along the axis. Within a piece of length e, with theta = (z -
// begin)/e, L is the sum of L(begin) exp(-e theta/s) and of a solution that starts at 0. The two
// terms of L are power series in theta, whose coefficients q_n satisfy
//
//     q_{n+1} = (e/s) (-q_n + w b_n) / (n + 1).
//
// For n > p the terms are terms of an exponential series: the remainder of the series after the
// term n = N - 1 is at most |q_N| exp(e/s).
#include <algorithm>
#include <cmath>

#include "backward/generator/impulse_mean_table.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kOneSidedOrder = 16;  // number N of coefficients of the power series

// Bernstein coefficients in theta of the two solutions on a piece.
struct OneSidedSolution {
  numerics::BernsteinCoefficients decay;  ///< decay exp(-e theta/s) of the integral L
  std::vector<numerics::BernsteinCoefficients>
      forced;                      ///< solution for each function of the piece, 0 at theta = 0
  numerics::Interval final_decay;  ///< decay exp(-e/s) over the whole piece
};

numerics::BernsteinCoefficients enclose_series(numerics::BernsteinCoefficients powers,
                                               const numerics::Interval& next,
                                               const numerics::Interval& ratio) {
  const numerics::Interval growth = 1.0 / exponential(-ratio);
  const double rest = (magnitude(next) * growth).upper();
  numerics::BernsteinCoefficients b = bernstein_from_power_coefficients(powers);
  for (numerics::Interval& c : b) c += numerics::symmetric_interval(rest);
  return b;
}

OneSidedSolution solve_one_sided(const std::vector<numerics::BernsteinCoefficients>& functions,
                                 const numerics::Interval& length, double s, double weight) {
  const numerics::Interval ratio = length / s;
  OneSidedSolution solution;
  solution.final_decay = exponential(-ratio);
  const auto series = [&](const numerics::BernsteinCoefficients& forcing,
                          const numerics::Interval& start) {
    numerics::BernsteinCoefficients q(kOneSidedOrder);
    numerics::Interval next = start;
    for (int n = 0; n < kOneSidedOrder; ++n) {
      q[n] = next;
      const numerics::Interval b =
          n < static_cast<int>(forcing.size()) ? forcing[n] : numerics::Interval(0);
      next = ratio * (weight * b - q[n]) / static_cast<double>(n + 1);
    }
    return enclose_series(std::move(q), next, ratio);
  };
  solution.decay = series({}, numerics::Interval(1));
  for (const numerics::BernsteinCoefficients& b : functions) {
    solution.forced.push_back(series(power_coefficients_from_bernstein(b), numerics::Interval(0)));
  }
  return solution;
}

// Velocity pieces shifted by the offset of the law, in increasing order. Additional pieces lie
// between the shifted pieces and the ends of the basis.
struct ShiftedAxis {
  std::vector<VelocityPiece> pieces;
  std::size_t first = 0;  ///< index of the shifted first piece
};

ShiftedAxis shifted_axis(const ImpactBasis& basis, const std::vector<VelocityPiece>& pieces,
                         const numerics::Interval& shift, double longest) {
  ShiftedAxis axis;
  const numerics::Interval begin = pieces.front().from + shift, end = pieces.back().to + shift;
  const auto add_between = [&](const numerics::Interval& from, const numerics::Interval& to) {
    for (const VelocityPiece& p : velocity_pieces(basis, {}, longest)) {
      if (p.to.upper() <= from.lower() || p.from.lower() >= to.upper()) continue;
      const numerics::Interval a = p.from.lower() < from.lower() ? from : p.from;
      const numerics::Interval b = p.to.upper() > to.upper() ? to : p.to;
      axis.pieces.push_back(velocity_piece_of_segment(basis, a, b));
    }
  };
  if (shift.lower() > 0) add_between(pieces.front().from, begin);
  axis.first = axis.pieces.size();
  for (const VelocityPiece& p : pieces) {
    axis.pieces.push_back(velocity_piece_of_segment(basis, p.from + shift, p.to + shift));
  }
  if (shift.upper() < 0) add_between(end, pieces.back().to);
  return axis;
}

// Weights w of the integral L over velocities below z and of the integral R over velocities above
// z, where z is the velocity v plus the shift of the law.
struct TailWeights {
  double below, above;
};

ImpulseMeanTable make_tail_table(const numerics::Interval& shift, double s,
                                 const TailWeights& weights, const ImpactBasis& basis,
                                 const std::vector<VelocityPiece>& pieces) {
  ImpulseMeanTable table = zero_impulse_mean_table(basis, pieces, kOneSidedOrder);
  double longest = 0, overhang = 0;
  for (const VelocityPiece& piece : pieces) longest = std::max(longest, piece.length().upper());
  const ShiftedAxis axis = shifted_axis(basis, pieces, shift, longest);
  const int count = static_cast<int>(axis.pieces.size());

  for (const bool forward : {true, false}) {
    const double weight = forward ? weights.below : weights.above;
    if (weight == 0) continue;
    // Values of L at the lower end of the axis, or of R at the upper end, for all basis functions.
    // Beyond the ends every basis function is constant.
    std::vector<numerics::Interval> end_values(basis.size(), numerics::Interval(0));
    end_values[forward ? 0 : basis.size() - 1] = weight;
    for (int step = 0; step < count; ++step) {
      const int i = forward ? step : count - 1 - step;
      const VelocityPiece& piece = axis.pieces[i];
      BasisFunctionsOnPiece functions = basis_functions_on_piece(basis, piece);
      overhang = std::max(overhang, functions.overhang_error);
      if (!forward) {
        for (numerics::BernsteinCoefficients& b : functions.value) std::reverse(b.begin(), b.end());
      }
      const OneSidedSolution solution = solve_one_sided(functions.value, piece.length(), s, weight);
      const int target = i - static_cast<int>(axis.first);
      if (target >= 0 && target < static_cast<int>(pieces.size())) {
        const auto add = [&](int b, const numerics::Interval& factor,
                             const numerics::BernsteinCoefficients& c) {
          const std::span<numerics::Interval> out = table.coefficients_of(target, b);
          for (int j = 0; j < kOneSidedOrder; ++j) {
            out[j] += factor * c[forward ? j : kOneSidedOrder - 1 - j];
          }
        };
        for (int b = 0; b < basis.size(); ++b) add(b, end_values[b], solution.decay);
        for (std::size_t l = 0; l < functions.index.size(); ++l) {
          add(functions.index[l], numerics::Interval(1), solution.forced[l]);
        }
      }
      for (numerics::Interval& c : end_values) c *= solution.final_decay;
      for (std::size_t l = 0; l < functions.index.size(); ++l) {
        end_values[functions.index[l]] += solution.forced[l].back();
      }
    }
  }
  // A bound of the error of a spline B on the whole axis also bounds the error of the mean K B
  // after an impulse.
  table.remainder = (2.0 * (basis.speeds().degree() + 1.0) * numerics::Interval(overhang)).upper();
  // If all shifted pieces are beyond the range of the basis, no pieces connect the shifted pieces
  // with the range, and no bound is valid.
  const double range_length = (pieces.back().to - pieces.front().from).lower();
  if (!(magnitude(shift) < range_length)) table.remainder = HUGE_VAL;
  return table;
}

}  // namespace

ImpulseMeanTable impulse_mean_table_of_law(const problem::LaplaceLaw& law, const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces) {
  return make_tail_table(law.mean, law.scale, {0.5, 0.5}, basis, pieces);
}

ImpulseMeanTable impulse_mean_table_of_law(const problem::ExponentialLaw& law,
                                           const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces) {
  const numerics::Interval start = numerics::Interval(law.mean) - law.scale;
  return make_tail_table(start, std::abs(law.scale),
                         law.scale > 0 ? TailWeights{0, 1} : TailWeights{1, 0}, basis, pieces);
}

}  // namespace fpkcheck::backward
