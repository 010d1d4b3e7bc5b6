#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace fpkcheck::mcs {

/// Piecewise quantile function of an amplitude law: maps a number u of (0, 1) to an amplitude. Used
/// for laws without a formula that SIMD lanes can evaluate.
class PiecewiseQuantileFunction {
 public:
  /// One piece of the quantile function: a polynomial of s. On the piece s grows with u from 0 to
  /// 1, as a quantile of a density on (0, 1) that is linear between two values. If both values are
  /// equal, s is linear in u.
  struct Piece {
    double upper_end;  ///< value of u at the end of the piece
    std::array<double, 8> powers;
    double first_density = 1, last_density = 1;
  };

  explicit PiecewiseQuantileFunction(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  double operator()(double u) const;
  /// Hash of all bits of the pieces. The hash identifies the law in checkpoints.
  std::uint64_t checksum() const;

 private:
  std::vector<Piece> pieces_;
};

/// An interval of amplitudes with its probability and a density that is linear between two values.
/// An interval with equal ends is an atom.
struct AmplitudeInterval {
  double from, to;
  double probability;
  double first_density = 1, last_density = 1;
};
/// The quantile function of a law that consists of increasing intervals; their probabilities sum to
/// 1.
PiecewiseQuantileFunction quantile_function_of_intervals(
    const std::vector<AmplitudeInterval>& ranges);

/// Interpolates a quantile function by pieces. The arguments of `quantile` are p and q = 1 - p, the
/// smaller one with full precision; the function is smooth inside (0, 1). A piece extends over a
/// quarter of an octave of u or 1 - u. Its polynomial passes through the values at the Chebyshev
/// points. The pieces extend from 2^-44, half of the smallest UniformNumbers::second, to 1 - 2^-44.
PiecewiseQuantileFunction interpolate_quantile_function(
    const std::function<double(double p, double q)>& quantile);

}  // namespace fpkcheck::mcs
