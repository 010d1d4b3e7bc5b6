#include "mcs/impulses/piecewise_quantile_function.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fpkcheck::mcs {
namespace {

using Piece = PiecewiseQuantileFunction::Piece;

constexpr int kOctaves = 43;  // octaves of u below 1/2, down to 2^-44
constexpr int kParts = 4;     // pieces of the quantile function per octave of u

// Returns the coefficients of the polynomial that interpolates the function `of_t` at the Chebyshev
// points of [0, 1], by Newton's divided differences.
std::array<double, 8> chebyshev_interpolant(const std::function<double(double)>& of_t) {
  constexpr std::size_t kPoints = std::tuple_size_v<decltype(Piece::powers)>;
  std::array<double, kPoints> t{}, difference{}, powers{};
  for (std::size_t k = 0; k < kPoints; ++k) {
    t[k] = (1 - std::cos((static_cast<double>(k) + 0.5) * std::numbers::pi / kPoints)) / 2;
    difference[k] = of_t(t[k]);
  }
  for (std::size_t order = 1; order < kPoints; ++order) {
    for (std::size_t k = kPoints; k-- > order;) {
      difference[k] = (difference[k] - difference[k - 1]) / (t[k] - t[k - order]);
    }
  }
  for (std::size_t k = kPoints; k-- > 0;) {  // invariant: powers <- powers (t - t_k) + difference_k
    for (std::size_t n = kPoints - 1; n > 0; --n) powers[n] = powers[n - 1] - t[k] * powers[n];
    powers[0] = difference[k] - t[k] * powers[0];
  }
  return powers;
}

}  // namespace

double PiecewiseQuantileFunction::operator()(double u) const {
  const auto piece = std::upper_bound(pieces_.begin(), pieces_.end() - 1, u,
                                      [](double x, const Piece& p) { return x < p.upper_end; });
  const double from = piece == pieces_.begin() ? 0 : (piece - 1)->upper_end;
  const double t = (u - from) / (piece->upper_end - from);
  // With the densities f and g at the two ends of a piece, the function s(t) solves t (f + g) = 2 f
  // s + (g - f) s^2. The quadratic equation for s is solved without cancellation.
  const double f = piece->first_density, g = piece->last_density;
  const double s = f == g ? t : t * (f + g) / (f + std::sqrt(f * f + t * (g - f) * (g + f)));
  double sum = 0;
  for (std::size_t n = piece->powers.size(); n-- > 0;) sum = sum * s + piece->powers[n];
  return sum;
}

std::uint64_t PiecewiseQuantileFunction::checksum() const {
  std::uint64_t sum = 0xcbf29ce484222325;  // FNV-1a hash, applied to words of 64 bits
  const auto add = [&](double x) { sum = (sum ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; };
  for (const Piece& piece : pieces_) {
    add(piece.upper_end);
    for (const double power : piece.powers) add(power);
    add(piece.first_density);
    add(piece.last_density);
  }
  return sum;
}

PiecewiseQuantileFunction quantile_function_of_intervals(
    const std::vector<AmplitudeHistogramInterval>& intervals) {
  std::vector<Piece> pieces;
  double below = 0;
  for (const AmplitudeHistogramInterval& range : intervals) {
    below += range.probability;
    if (below <= (pieces.empty() ? 0 : pieces.back().upper_end))
      continue;  // no piece for an empty interval of u
    pieces.push_back({.upper_end = below,
                      .powers = {range.from, range.to - range.from},
                      .first_density = range.first_density,
                      .last_density = range.last_density});
  }
  pieces.back().upper_end = 1;
  return PiecewiseQuantileFunction(std::move(pieces));
}

PiecewiseQuantileFunction interpolate_quantile_function(
    const std::function<double(double p, double q)>& quantile) {
  std::vector<double> ends;  // increasing ends of the pieces, up to 1/2
  for (int octave = kOctaves; octave > 0; --octave) {
    for (int part = 0; part < kParts; ++part) {
      ends.push_back(std::ldexp(1 + static_cast<double>(part) / kParts, -octave - 1));
    }
  }
  ends.push_back(0.5);
  // The first piece is constant, since no random number u lies in the first piece.
  std::vector<Piece> pieces{{ends.front(), {quantile(ends.front(), 1 - ends.front())}}};
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double from = ends[k], length = ends[k + 1] - from;
    pieces.push_back({ends[k + 1], chebyshev_interpolant([&](double t) {
                        const double p = from + t * length;
                        return quantile(p, 1 - p);
                      })});
  }
  for (std::size_t k = ends.size() - 1; k > 0; --k) {
    const double from = ends[k], length = from - ends[k - 1];
    pieces.push_back({1 - ends[k - 1], chebyshev_interpolant([&](double t) {
                        const double q = from - t * length;
                        return quantile(1 - q, q);
                      })});
  }
  return PiecewiseQuantileFunction(std::move(pieces));
}

}  // namespace fpkcheck::mcs
