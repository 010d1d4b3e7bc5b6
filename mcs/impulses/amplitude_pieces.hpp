#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace fpkcheck::mcs {

/// An amplitude as a function of one number of (0, 1), its law's quantile function, in pieces: for
/// laws that lanes cannot draw by a formula.
class AmplitudePieces {
 public:
  /// A polynomial of s. On the piece s goes from 0 to 1 as one drawn with a density that is linear
  /// between two values: with the number itself, where they are equal.
  struct Piece {
    double until;  ///< the number at its end, where the next one begins
    std::array<double, 8> powers;
    double first_density = 1, last_density = 1;
  };

  explicit AmplitudePieces(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  double operator()(double u) const;
  /// Of all their bits: other pieces, other amplitudes.
  std::uint64_t checksum() const;

 private:
  std::vector<Piece> pieces_;
};

/// A piece of the amplitudes from .. to with its probability, the density there linear from one
/// value to the other; an atom where they are the same.
struct AmplitudeRange {
  double from, to;
  double probability;
  double first_density = 1, last_density = 1;
};
/// Of increasing ranges with probabilities that sum to 1.
AmplitudePieces in_ranges(const std::vector<AmplitudeRange>& ranges);

/// Of a quantile function of p and q = 1 - p, of which the smaller one has all its digits, that is
/// smooth inside (0, 1): on each piece, a quarter of an octave of u or
/// 1 - u, the polynomial through its values at Chebyshev's points. From 2^-44, half of the smallest
/// Uniforms::second, to 1 - 2^-44.
AmplitudePieces interpolated(const std::function<double(double, double)>& quantile);

}  // namespace fpkcheck::mcs
