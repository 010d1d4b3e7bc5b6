// Tables of the means K B of splines B after an impulse of the uniform law or the two-point law.
// The mean K B of a spline B is a polynomial on each piece: a piece ends at every velocity from
// which an atom of the law, or an end of the uniform law, leads to a break of B.
//
// Uniform law, Y on (m - h, m + h): K B(v) = (I(v + m + h) - I(v + m - h)) / (2h) with I' = B.
// Two-point law of the impulse Y, where Y = m - s or Y = m + s with probability 1/2 each: K B(v) =
// (B(v + m - s) + B(v + m + s)) / 2.
#include "backward/generator/impulse_mean_table.hpp"

namespace fpkcheck::backward {
namespace {

// Integrals I(v) = int_{-u_max}^v B_b(z) dz of all splines B_b of v. The class stores the integrals
// I(v) at the beginning of each knot span and at the end of the last knot span.
class BasisFunctionIntegrals {
 public:
  explicit BasisFunctionIntegrals(const ImpactSplineBasis& basis) : basis_(basis) {
    std::vector<numerics::Interval> sum(basis.size(), numerics::Interval(0));
    spans_ =
        divide_velocity_axis(basis, {}, 4 * (basis.highest_velocity() - basis.lowest_velocity()));
    for (const VelocityAxisPiece& span : spans_) {
      values_at_span_begin_.push_back(sum);
      const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis, span);
      for (std::size_t l = 0; l < functions.indices.size(); ++l) {
        sum[functions.indices[l]] += span.length() * mean(functions.polynomials[l]);
      }
    }
    values_at_span_begin_.push_back(sum);
  }

  /// Adds factor * I to the Bernstein coefficients of each spline on a piece, where I is the
  /// integral of the spline.
  /// @param coefficients shape (number of splines, order)
  /// @return an upper bound of |I - polynomial|
  double add_multiple(const VelocityAxisPiece& piece, const numerics::Interval& factor,
                      std::span<numerics::Interval> coefficients, int order) const {
    const BasisFunctionsOnVelocityPiece functions = basis_functions_on_piece(basis_, piece);
    const int span_index = span_position(piece);
    const bool below = piece.side == VelocityAxisPart::below;
    for (int b = 0; b < basis_.size(); ++b) {
      for (int j = 0; j < order; ++j)
        coefficients[b * order + j] += factor * values_at_span_begin_[span_index][b];
    }
    // The gap of the integral of a spline extends from the beginning of the knot span to the piece.
    // For a piece below the range of the splines of v, the gap is from the piece to the range.
    const numerics::Interval begin =
        span_index < static_cast<int>(spans_.size()) ? spans_[span_index].begin : spans_.back().end;
    const VelocityAxisPiece gap{piece.side, piece.knot_span, begin, piece.begin, 0};
    const BasisFunctionsOnVelocityPiece functions_on_gap = basis_functions_on_piece(basis_, gap);
    for (std::size_t l = 0; l < functions.indices.size(); ++l) {
      numerics::BernsteinCoefficients integral(functions.polynomials[l].size() + 1);
      integral[0] =
          below ? piece.begin - begin : gap.length() * mean(functions_on_gap.polynomials[l]);
      const numerics::Interval step =
          piece.length() / static_cast<double>(functions.polynomials[l].size());
      for (std::size_t j = 0; j + 1 < integral.size(); ++j) {
        integral[j + 1] = integral[j] + step * functions.polynomials[l][j];
      }
      integral = elevate_bernstein_degree(integral, order - 1);
      for (int j = 0; j < order; ++j) {
        coefficients[functions.indices[l] * order + j] += factor * integral[j];
      }
    }
    return (numerics::Interval(piece.rounding_overhang) * functions.overhang_error).upper();
  }

 private:
  // Returns the mean of a polynomial over its segment of the velocity axis.
  static numerics::Interval mean(const numerics::BernsteinCoefficients& b) {
    numerics::Interval sum = 0;
    for (const numerics::Interval& c : b) sum += c;
    return sum / static_cast<double>(b.size());
  }
  // Returns the position of the knot span of a piece among the knot spans in increasing order of v.
  int span_position(const VelocityAxisPiece& piece) const {
    const int count = basis_.speed_basis().break_span_count();
    switch (piece.side) {
      case VelocityAxisPart::below:
        return 0;
      case VelocityAxisPart::incoming:
        return count - 1 - piece.knot_span;
      case VelocityAxisPart::outgoing:
        return count + piece.knot_span;
      case VelocityAxisPart::above:
        return 2 * count;
    }
    return 0;
  }

  const ImpactSplineBasis& basis_;
  std::vector<VelocityAxisPiece> spans_;
  std::vector<std::vector<numerics::Interval>> values_at_span_begin_;
};

}  // namespace

PostImpulseMeanTable tabulate_impulse_means(const problem::UniformLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces) {
  const int order = basis.speed_basis().degree() + 2;
  PostImpulseMeanTable table = make_zero_impulse_mean_table(basis, pieces, order);
  const BasisFunctionIntegrals integrals(basis);
  numerics::Interval error = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::span<numerics::Interval> out(
        table.post_impulse_mean_coefficients(static_cast<int>(i), 0).data(),
        static_cast<std::size_t>(basis.size() * order));
    for (const double sign : {-1.0, 1.0}) {
      const numerics::Interval shift = numerics::Interval(law.mean) + sign * law.half_width;
      const VelocityAxisPiece shifted_piece =
          make_velocity_piece(basis, pieces[i].begin + shift, pieces[i].end + shift);
      const numerics::Interval factor = sign / (2.0 * numerics::Interval(law.half_width));
      const double piece_error = integrals.add_multiple(shifted_piece, factor, out, order);
      error =
          std::max(error.upper(), (magnitude(factor) * numerics::Interval(piece_error)).upper());
    }
  }
  // Each of the shifted integrals of splines depends on splines of at most two knot spans.
  table.remainder_bound = (4.0 * (basis.speed_basis().degree() + 1.0) * error).upper();
  return table;
}

PostImpulseMeanTable tabulate_impulse_means(const problem::TwoPointLaw& law,
                                            const ImpactSplineBasis& basis,
                                            const std::vector<VelocityAxisPiece>& pieces) {
  const int order = basis.speed_basis().degree() + 2;  // order of the term v V_y of the generator
  PostImpulseMeanTable table = make_zero_impulse_mean_table(basis, pieces, order);
  double overhang = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const numerics::Interval shift = numerics::Interval(law.mean) + sign * law.deviation;
      const BasisFunctionsOnVelocityPiece shifted_functions = basis_functions_on_piece(
          basis, make_velocity_piece(basis, pieces[i].begin + shift, pieces[i].end + shift));
      overhang = std::max(overhang, shifted_functions.overhang_error);
      for (std::size_t l = 0; l < shifted_functions.indices.size(); ++l) {
        const numerics::BernsteinCoefficients b =
            elevate_bernstein_degree(shifted_functions.polynomials[l], order - 1);
        const std::span<numerics::Interval> out =
            table.post_impulse_mean_coefficients(static_cast<int>(i), shifted_functions.indices[l]);
        for (int j = 0; j < order; ++j) out[j] += b[j] / 2.0;
      }
    }
  }
  // At each velocity the error of the integrals affects <= 2 (p + 1) splines of two knot spans.
  table.remainder_bound =
      (2.0 * (basis.speed_basis().degree() + 1.0) * numerics::Interval(overhang)).upper();
  return table;
}

}  // namespace fpkcheck::backward
