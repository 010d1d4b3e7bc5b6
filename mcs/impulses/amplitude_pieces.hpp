#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace fpkcheck::mcs {

/// Piecewise quantile function of an amplitude law, a function of one number u of (0, 1). For laws
/// without a formula that SIMD lanes can evaluate.
class AmplitudePieces {
 public:
  /// A polynomial of s. On the piece s grows with u from 0 to 1 as a quantile of a density that is
  /// linear between two values; s is linear in u where both values are equal.
  struct Piece {
    double upper_end;  ///< u at the end of the piece
    std::array<double, 8> powers;
    double first_density = 1, last_density = 1;
  };

  explicit AmplitudePieces(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  double operator()(double u) const;
  /// Hash of all bits of the pieces, which identifies the law in checkpoints.
  std::uint64_t checksum() const;

 private:
  std::vector<Piece> pieces_;
};

/// An interval of amplitudes with its probability and a density linear between two values; an atom
/// where both ends are equal.
struct AmplitudeRange {
  double from, to;
  double probability;
  double first_density = 1, last_density = 1;
};
/// Pieces from increasing intervals whose probabilities sum to 1.
AmplitudePieces pieces_from_ranges(const std::vector<AmplitudeRange>& ranges);

/// Pieces from a quantile function of p and q = 1 - p, smooth inside (0, 1). The smaller of p and q
/// has full precision. A piece is a quarter of an octave of u or 1 - u, with the polynomial through
/// the values at the Chebyshev points. The pieces extend from 2^-44, half of the smallest
/// Uniforms::second, to 1 - 2^-44.
AmplitudePieces pieces_from_quantile(const std::function<double(double, double)>& quantile);

}  // namespace fpkcheck::mcs
