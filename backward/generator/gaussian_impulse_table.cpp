// The Gaussian law is Y ~ N(m, s^2). With v = v0 + h x on the target piece, z = z0 + g y on a
// source piece, D = (z0 - v0 - m)/s and the Hermite polynomials He, the mean after an impulse is
//
//     K B(v) = int B(z) phi((z - v - m)/s) dz/s
//            = sum_{q,k} x^q (h/s)^q/q! (-1)^k (g/s)^k/k! He_{q+k}(D) phi(D) int B y^k dz/s.
//
// Truncation errors of the sum over q and k, for |V| <= 1, as the splines are positive with sum 1:
// - sources beyond kSourceRange deviations: P(|Y - m| > kSourceRange s) <= 2
//   exp(-kSourceRange^2/2);
// - q >= N: |d^N/dv^N K V| <= s^-N E|He_N| <= s^-N sqrt(N!), so (h/s)^N / sqrt(N!);
// - k >= K: |He_n phi| <= 0.44 sqrt(n!) (Cramer) and (q+k)! <= 2^(q+k) q! k!. With a = sqrt(2) g/s
//   and b = sqrt(2) h/s the truncation error is at most 0.44 (2g/s) b^q/sqrt(q!) sum_{k>=K}
//   a^k/sqrt(k!).
#include <cmath>
#include <stdexcept>

#include "backward/generator/impulse_mean_table.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kTaylorTerms = 16;    // number N of terms of the Taylor series in the target piece
constexpr int kSourceMoments = 20;  // number K of moments of a source piece
constexpr double kSourceRange = 9;  // largest |z - v - m| of the integral, in standard deviations

numerics::Interval centre_of(const VelocityAxisPiece& piece) {
  return (piece.begin + piece.end) / 2.0;
}

numerics::Interval factorial(int n) {
  numerics::Interval f = 1;
  for (int i = 2; i <= n; ++i) f *= static_cast<double>(i);
  return f;
}

// Returns the Bernstein coefficients of degree n in t of the power x^q of x = 2t - 1.
numerics::BernsteinCoefficients bernstein_coefficients_of_power(int q, int n) {
  const numerics::BernsteinCoefficients x{numerics::Interval(-1), numerics::Interval(1)};
  numerics::BernsteinCoefficients b{numerics::Interval(1)};
  for (int i = 0; i < q; ++i) b = bernstein_product(b, x);
  return elevate_bernstein_degree(b, n);
}

// Returns the integrals int_0^1 B_j^p(t) (2t - 1)^k dt of the Bernstein polynomials B_j^p of degree
// p, shape (p + 1, kSourceMoments). Each integral of a polynomial over [0, 1] is the mean of its
// Bernstein coefficients.
std::vector<std::vector<numerics::Interval>> bernstein_moment_integrals(int p) {
  const numerics::BernsteinCoefficients x{numerics::Interval(-1), numerics::Interval(1)};
  std::vector<std::vector<numerics::Interval>> integrals(
      p + 1, std::vector<numerics::Interval>(kSourceMoments));
  for (int j = 0; j <= p; ++j) {
    numerics::BernsteinCoefficients b(p + 1, numerics::Interval(0));
    b[j] = 1;
    for (int k = 0; k < kSourceMoments; ++k) {
      numerics::Interval sum = 0;
      for (const numerics::Interval& c : b) sum += c;
      integrals[j][k] = sum / static_cast<double>(b.size());
      b = bernstein_product(b, x);
    }
  }
  return integrals;
}

// Piece of the axis of the velocity z after an impulse, with its contributions to the means K B.
struct PostImpulseVelocityPiece {
  numerics::Interval centre;          // z0
  double half_length;                 // g
  std::vector<int> function_indices;  // indices of the functions B that are nonzero on the piece
  // Integrals (-1)^k (g/s)^k/k! int B y^k dz/s of each spline B, shape (splines, kSourceMoments)
  std::vector<std::vector<numerics::Interval>> moments;
};

PostImpulseVelocityPiece make_source_piece(
    const ImpactSplineBasis& basis, const VelocityAxisPiece& piece, double s,
    const std::vector<std::vector<numerics::Interval>>& integrals) {
  const numerics::Interval half = piece.length() / 2.0;
  const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, piece);
  PostImpulseVelocityPiece source{centre_of(piece), half.upper(), functions.indices, {}};
  for (const numerics::BernsteinCoefficients& b : functions.polynomials) {
    std::vector<numerics::Interval> moments(kSourceMoments);
    numerics::Interval factor = 2.0 * half / s;
    for (int k = 0; k < kSourceMoments; ++k) {
      if (k > 0) factor *= -half / s / static_cast<double>(k);
      numerics::Interval sum = 0;
      for (std::size_t j = 0; j < b.size(); ++j) sum += b[j] * integrals[j][k];
      moments[k] = factor * sum;
    }
    source.moments.push_back(std::move(moments));
  }
  return source;
}

// Returns an upper bound of the sum of a^n / sqrt(n!) over all n >= first. For a <= 3/4 the ratio
// of consecutive terms a^n / sqrt(n!) is at most 3/4.
numerics::Interval root_factorial_tail(const numerics::Interval& a, int first) {
  if (!(a.upper() <= 0.75)) throw std::logic_error("gaussian table: velocity pieces too long");
  return 4.0 * power(a, first) / sqrt(factorial(first));
}

}  // namespace

PostImpulseMeanTable tabulate_impulse_means(const problem::GaussianLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces) {
  const double s = law.deviation;
  PostImpulseMeanTable table = make_zero_impulse_mean_table(basis, pieces, kTaylorTerms);
  const auto integrals = bernstein_moment_integrals(basis.speed_basis().degree());

  // The integral over the velocity after an impulse extends beyond the ends of the splines of v,
  // where the first or the last spline is 1.
  std::vector<VelocityAxisPiece> source_pieces(pieces);
  const double source_range = kSourceRange * s + std::abs(law.mean) + s, step = 0.6 * s;
  double widest = 0;
  for (const VelocityAxisPiece& piece : pieces) widest = std::max(widest, piece.length().upper());
  for (numerics::Interval to = pieces.front().begin;
       to.upper() > basis.lowest_velocity() - source_range - widest;) {
    const numerics::Interval from = to.lower() - step;
    source_pieces.push_back({VelocityAxisPart::below, 0, numerics::Interval(from.lower()), to, 0});
    to = from.lower();
  }
  for (numerics::Interval from = pieces.back().end;
       from.lower() < basis.highest_velocity() + source_range + widest;) {
    const numerics::Interval to = from.upper() + step;
    source_pieces.push_back({VelocityAxisPart::above, 0, from, numerics::Interval(to.upper()), 0});
    from = to.upper();
  }
  std::vector<PostImpulseVelocityPiece> sources;
  double overhang = 0;
  for (const VelocityAxisPiece& piece : source_pieces) {
    sources.push_back(make_source_piece(basis, piece, s, integrals));
    overhang = std::max(overhang, basis_functions_on_piece(basis, piece).overhang_error);
  }

  std::vector<numerics::BernsteinCoefficients> bernstein;
  for (int q = 0; q < kTaylorTerms; ++q)
    bernstein.push_back(bernstein_coefficients_of_power(q, kTaylorTerms - 1));
  // 1/sqrt(2 pi) = 0.398942280401432677939946... in phi(D) = exp(-D^2/2) / sqrt(2 pi)
  const numerics::Interval root(0.3989422804014326, 0.3989422804014328);
  std::vector<numerics::Interval> hermite(kTaylorTerms + kSourceMoments);
  numerics::Interval largest_h = 0, largest_g = 0;
  for (const PostImpulseVelocityPiece& source : sources)
    largest_g = std::max(largest_g.upper(), source.half_length);

  std::vector<numerics::Interval> powers(static_cast<std::size_t>(basis.size() * kTaylorTerms));
  for (std::size_t target = 0; target < pieces.size(); ++target) {
    const numerics::Interval half = pieces[target].length() / 2.0, v0 = centre_of(pieces[target]);
    largest_h = std::max(largest_h.upper(), half.upper());
    std::fill(powers.begin(), powers.end(), numerics::Interval(0));
    for (const PostImpulseVelocityPiece& source : sources) {
      const numerics::Interval distance = (source.centre - v0 - law.mean) / s;
      if (std::max(distance.lower(), -distance.upper()) >
          kSourceRange + 1.001 * (half.upper() + source.half_length) / s) {
        continue;
      }
      hermite[0] = root * exponential(-square(distance) / 2.0);
      hermite[1] = distance * hermite[0];
      for (int n = 1; n + 1 < kTaylorTerms + kSourceMoments; ++n) {
        hermite[n + 1] = distance * hermite[n] - static_cast<double>(n) * hermite[n - 1];
      }
      for (std::size_t l = 0; l < source.function_indices.size(); ++l) {
        numerics::Interval* const out =
            &powers[static_cast<std::size_t>(source.function_indices[l] * kTaylorTerms)];
        for (int q = 0; q < kTaylorTerms; ++q) {
          numerics::Interval sum = 0;
          for (int k = 0; k < kSourceMoments; ++k) sum += hermite[q + k] * source.moments[l][k];
          out[q] += sum;
        }
      }
    }
    for (int b = 0; b < basis.size(); ++b) {
      const std::span<numerics::Interval> out =
          table.post_impulse_mean_coefficients(static_cast<int>(target), b);
      numerics::Interval factor = 1;
      for (int q = 0; q < kTaylorTerms; ++q) {
        if (q > 0) factor *= half / s / static_cast<double>(q);
        const numerics::Interval a =
            factor * powers[static_cast<std::size_t>(b * kTaylorTerms + q)];
        if (a.lower() == 0 && a.upper() == 0) continue;
        for (int j = 0; j < kTaylorTerms; ++j) out[j] += a * bernstein[q][j];
      }
    }
  }

  const numerics::Interval a = sqrt(numerics::Interval(2)) * largest_g / s,
                           b = sqrt(numerics::Interval(2)) * largest_h / s;
  // Total length of the source pieces (velocities after an impulse) of one target piece, in
  // standard deviations of the impulse law
  const numerics::Interval source_length =
      2.0 * (kSourceRange + 2.0 * (largest_h + 2.0 * largest_g) / s);
  const numerics::Interval moment_truncation =
      0.44 * source_length * root_factorial_tail(b, 0) * root_factorial_tail(a, kSourceMoments);
  const numerics::Interval taylor_truncation =
      power(largest_h / s, kTaylorTerms) / sqrt(factorial(kTaylorTerms));
  const numerics::Interval range_truncation =
      2.0 * exponential(numerics::Interval(-kSourceRange * kSourceRange / 2));
  const numerics::Interval overhang_error = 4.0 * (basis.speed_basis().degree() + 1.0) * overhang;
  table.remainder_bound =
      (moment_truncation + taylor_truncation + range_truncation + overhang_error).upper();
  return table;
}

}  // namespace fpkcheck::backward
