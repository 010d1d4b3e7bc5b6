// Impulse tables of the laws with a piecewise constant density or with two atoms. The mean K B of a
// spline B after an impulse is a polynomial on each piece. Pieces end at velocities from which an
// edge or an atom of the law leads to a break of B.
//
// Uniform law, Y on (m - h, m + h): K B(v) = (I(v + m + h) - I(v + m - h)) / (2h) with I' = B.
// Two-point law, Y = m -+ s with probability 1/2 each: K B(v) = (B(v + m - s) + B(v + m + s)) / 2.
#include "backward/generator/impulse_mean_table.hpp"

namespace fpkcheck::backward {
namespace {

// Integrals I(v) = int_{begin}^v B of all functions, at the beginning of each span and at the end
// of the last span.
class Antiderivative {
 public:
  explicit Antiderivative(const ImpactBasis& basis) : basis_(basis) {
    std::vector<numerics::Interval> sum(basis.size(), numerics::Interval(0));
    spans_ = velocity_pieces(basis, {}, 4 * (basis.end() - basis.begin()));
    for (const VelocityPiece& span : spans_) {
      at_begin_.push_back(sum);
      const BasisFunctionsOnPiece functions = basis_functions_on_piece(basis, span);
      for (std::size_t l = 0; l < functions.index.size(); ++l) {
        sum[functions.index[l]] += span.length() * mean(functions.value[l]);
      }
    }
    at_begin_.push_back(sum);
  }

  /// Adds factor * I on the piece to `coefficients` of each function, shape (size, order).
  /// @return an upper bound of |I - polynomial|
  double add(const VelocityPiece& piece, const numerics::Interval& factor,
             std::span<numerics::Interval> coefficients, int order) const {
    const BasisFunctionsOnPiece functions = basis_functions_on_piece(basis_, piece);
    const int span_index = span_number(piece);
    const bool below = piece.side == VelocitySide::below;
    for (int b = 0; b < basis_.size(); ++b) {
      for (int j = 0; j < order; ++j)
        coefficients[b * order + j] += factor * at_begin_[span_index][b];
    }
    // The gap extends from the beginning of the span to the piece. For a piece below the range of
    // the basis, the gap extends from the piece to the beginning of the range.
    const numerics::Interval begin =
        span_index < static_cast<int>(spans_.size()) ? spans_[span_index].from : spans_.back().to;
    const VelocityPiece gap{piece.side, piece.span, begin, piece.from, 0};
    const BasisFunctionsOnPiece across = basis_functions_on_piece(basis_, gap);
    for (std::size_t l = 0; l < functions.index.size(); ++l) {
      numerics::BernsteinCoefficients integral(functions.value[l].size() + 1);
      integral[0] = below ? piece.from - begin : gap.length() * mean(across.value[l]);
      const numerics::Interval step =
          piece.length() / static_cast<double>(functions.value[l].size());
      for (std::size_t j = 0; j + 1 < integral.size(); ++j) {
        integral[j + 1] = integral[j] + step * functions.value[l][j];
      }
      integral = elevate_bernstein_degree(integral, order - 1);
      for (int j = 0; j < order; ++j) {
        coefficients[functions.index[l] * order + j] += factor * integral[j];
      }
    }
    return (numerics::Interval(piece.overhang) * functions.overhang_error).upper();
  }

 private:
  static numerics::Interval mean(const numerics::BernsteinCoefficients& b) {
    numerics::Interval sum = 0;
    for (const numerics::Interval& c : b) sum += c;
    return sum / static_cast<double>(b.size());
  }
  int span_number(const VelocityPiece& piece) const {
    const int count = basis_.speeds().span_count();
    switch (piece.side) {
      case VelocitySide::below:
        return 0;
      case VelocitySide::incoming:
        return count - 1 - piece.span;
      case VelocitySide::outgoing:
        return count + piece.span;
      case VelocitySide::above:
        return 2 * count;
    }
    return 0;
  }

  const ImpactBasis& basis_;
  std::vector<VelocityPiece> spans_;
  std::vector<std::vector<numerics::Interval>> at_begin_;
};

}  // namespace

ImpulseMeanTable impulse_mean_table_of_law(const problem::UniformLaw& law, const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces) {
  const int order = basis.speeds().degree() + 2;
  ImpulseMeanTable table = zero_impulse_mean_table(basis, pieces, order);
  const Antiderivative antiderivative(basis);
  numerics::Interval error = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::span<numerics::Interval> out(table.coefficients_of(static_cast<int>(i), 0).data(),
                                            static_cast<std::size_t>(basis.size() * order));
    for (const double sign : {-1.0, 1.0}) {
      const numerics::Interval shift = numerics::Interval(law.mean) + sign * law.half_width;
      const VelocityPiece there =
          velocity_piece_of_segment(basis, pieces[i].from + shift, pieces[i].to + shift);
      const numerics::Interval factor = sign / (2.0 * numerics::Interval(law.half_width));
      const double piece_error = antiderivative.add(there, factor, out, order);
      error =
          std::max(error.upper(), (magnitude(factor) * numerics::Interval(piece_error)).upper());
    }
  }
  // Each of the two shifted integrals depends on the functions of at most two spans.
  table.remainder = (4.0 * (basis.speeds().degree() + 1.0) * error).upper();
  return table;
}

ImpulseMeanTable impulse_mean_table_of_law(const problem::TwoPointLaw& law,
                                           const ImpactBasis& basis,
                                           const std::vector<VelocityPiece>& pieces) {
  const int order = basis.speeds().degree() + 2;  // order of the term v V_y of the generator
  ImpulseMeanTable table = zero_impulse_mean_table(basis, pieces, order);
  double overhang = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const numerics::Interval shift = numerics::Interval(law.mean) + sign * law.deviation;
      const BasisFunctionsOnPiece there = basis_functions_on_piece(
          basis, velocity_piece_of_segment(basis, pieces[i].from + shift, pieces[i].to + shift));
      overhang = std::max(overhang, there.overhang_error);
      for (std::size_t l = 0; l < there.index.size(); ++l) {
        const numerics::BernsteinCoefficients b =
            elevate_bernstein_degree(there.value[l], order - 1);
        const std::span<numerics::Interval> out =
            table.coefficients_of(static_cast<int>(i), there.index[l]);
        for (int j = 0; j < order; ++j) out[j] += b[j] / 2.0;
      }
    }
  }
  // At each velocity the error affects at most 2 (p + 1) functions, the basis functions of two
  // spans.
  table.remainder = (2.0 * (basis.speeds().degree() + 1.0) * numerics::Interval(overhang)).upper();
  return table;
}

}  // namespace fpkcheck::backward
