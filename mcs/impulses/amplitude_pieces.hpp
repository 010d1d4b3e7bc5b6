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
  /// A polynomial of t, which goes from 0 to 1 on the piece.
  struct Piece {
    double until;  ///< the number at its end, where the next one begins
    std::array<double, 8> powers;
  };

  explicit AmplitudePieces(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  double operator()(double u) const;
  /// Of all their bits: other pieces, other amplitudes.
  std::uint64_t checksum() const;

 private:
  std::vector<Piece> pieces_;
};

/// Of a quantile function of p and q = 1 - p, of which the smaller one has all its digits, that is
/// smooth inside (0, 1): on each piece, a quarter of an octave of u or
/// 1 - u, the polynomial through its values at Chebyshev's points. From 2^-44, half of the smallest
/// Uniforms::second, to 1 - 2^-44.
AmplitudePieces interpolated(const std::function<double(double, double)>& quantile);

}  // namespace fpkcheck::mcs
