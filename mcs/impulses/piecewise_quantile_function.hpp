#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace fpkcheck::mcs {

/// Piecewise quantile function of an amplitude law, which maps a uniform number u of (0, 1) to an
/// amplitude. Amplitude laws without a closed formula for SIMD lanes use PiecewiseQuantileFunction.
class PiecewiseQuantileFunction {
 public:
  /// Piece of the quantile function: a polynomial of a function s(u) of the uniform number u. The
  /// function s(u) grows from 0 to 1 and is the quantile function of a density on (0, 1) that is
  /// linear from first_density to last_density. If first_density equals last_density, s(u) is
  /// linear in the uniform number u.
  struct Piece {
    double upper_end;  ///< value of u at the end of the piece
    std::array<double, 8> powers;
    double first_density = 1, last_density = 1;
  };

  explicit PiecewiseQuantileFunction(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  double operator()(double u) const;
  /// Returns a hash of the quantile function, which identifies the law in checkpoint files.
  std::uint64_t checksum() const;

 private:
  std::vector<Piece> pieces_;
};

/// Interval of amplitudes, with its probability and a density that is linear from first_density to
/// last_density. An interval with equal ends is an atom.
struct AmplitudeHistogramInterval {
  double from, to;
  double probability;
  double first_density = 1, last_density = 1;
};
/// Returns the quantile function of an amplitude law from its amplitude intervals in increasing
/// order; the probabilities of the intervals have the sum 1.
PiecewiseQuantileFunction quantile_function_of_intervals(
    const std::vector<AmplitudeHistogramInterval>& intervals);

/// Interpolates a quantile function that is smooth inside (0, 1). Each piece of the quantile
/// function extends over a quarter of an octave of u or 1 - u. The polynomial of each piece
/// interpolates the quantile function at the Chebyshev points. The pieces of the quantile function
/// extend from 2^-44, the smallest value of UniformRandomNumbers::second, to 1 - 2^-44.
/// @param quantile quantile for p and q = 1 - p; the smaller of p and q has full precision
PiecewiseQuantileFunction interpolate_quantile_function(
    const std::function<double(double p, double q)>& quantile);

}  // namespace fpkcheck::mcs
