#include "backward/generator/impact_basis.hpp"

#include <cmath>

#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {
namespace {

// Returns the ends in v, in increasing order, of a knot span of the impact speed.
std::array<numerics::Interval, 2> velocity_span_ends(const ImpactSplineBasis& basis,
                                                     VelocityAxisPart side, int span) {
  const double u0 = basis.speed_basis().breaks()[span], u1 = basis.speed_basis().breaks()[span + 1];
  if (side == VelocityAxisPart::incoming) return {numerics::Interval(-u1), numerics::Interval(-u0)};
  const numerics::Interval r = basis.restitution();
  return {r * u0, r * u1};
}

double segment_midpoint(const numerics::Interval& begin, const numerics::Interval& end) {
  return (begin.lower() + end.upper()) / 2;
}

// Returns an upper bound of the slope |dB_b/dv| of all splines B_b at all v: degree p / (shortest
// knot interval in v).
double slope_bound(const ImpactSplineBasis& basis) {
  const std::span<const double> u = basis.speed_basis().breaks();
  double shortest = u[1] - u[0];
  for (std::size_t i = 1; i + 1 < u.size(); ++i) shortest = std::min(shortest, u[i + 1] - u[i]);
  return 1.01 * basis.speed_basis().degree() / (shortest * std::min(1.0, basis.restitution()));
}

}  // namespace

VelocityAxisPiece make_velocity_piece(const ImpactSplineBasis& basis,
                                      const numerics::Interval& begin,
                                      const numerics::Interval& end) {
  const double v = segment_midpoint(begin, end), r = basis.restitution();
  VelocityAxisPiece piece{VelocityAxisPart::below, 0, begin, end, 0};
  if (v < basis.lowest_velocity()) {
    piece.rounding_overhang = std::max(0.0, (end - basis.lowest_velocity()).upper());
  } else if (v > basis.highest_velocity()) {
    piece.side = VelocityAxisPart::above;
    piece.rounding_overhang =
        std::max(0.0, (numerics::Interval(r) * basis.speed_basis().end() - begin).upper());
  } else {
    piece.side = v < 0 ? VelocityAxisPart::incoming : VelocityAxisPart::outgoing;
    piece.knot_span = basis.speed_basis().knot_span_containing(v < 0 ? -v : v / r);
    const auto [span_begin, span_end] = velocity_span_ends(basis, piece.side, piece.knot_span);
    piece.rounding_overhang =
        std::max({0.0, (span_begin - begin).upper(), (end - span_end).upper()});
  }
  return piece;
}

BasisFunctionsOnVelocityPiece basis_functions_on_piece(const ImpactSplineBasis& basis,
                                                       const VelocityAxisPiece& piece) {
  const int p = basis.speed_basis().degree();
  BasisFunctionsOnVelocityPiece functions;
  double slope = 0;
  if (piece.side == VelocityAxisPart::below || piece.side == VelocityAxisPart::above) {
    functions.indices = {piece.side == VelocityAxisPart::below ? 0 : basis.size() - 1};
    functions.polynomials = {numerics::BernsteinCoefficients(p + 1, numerics::Interval(1))};
  } else {
    const bool in = piece.side == VelocityAxisPart::incoming;
    const numerics::Interval r = basis.restitution();
    const auto rows = numerics::bezier_extraction<numerics::Interval>(
        basis.speed_basis(), piece.knot_span,
        in ? numerics::Interval(-piece.begin) : piece.begin / r,
        in ? numerics::Interval(-piece.end) : piece.end / r);
    for (int l = 0; l <= p; ++l) {
      functions.indices.push_back(in ? basis.incoming_basis_index(piece.knot_span + l)
                                     : basis.outgoing_basis_index(piece.knot_span + l));
      functions.polynomials.emplace_back(rows.row(l).begin(), rows.row(l).end());
      for (int j = 0; j < p; ++j) {
        slope = std::max(slope, magnitude(rows(l, j + 1) - rows(l, j)));
      }
    }
    slope = (slope * p / numerics::Interval(piece.length().lower())).upper();
  }
  // At the end of the knot span the polynomial on the piece equals the spline. On the overhang
  // beyond the knot span, the polynomial and the spline differ by at most the length of the
  // overhang times the sum of the bounds of their slopes.
  functions.overhang_error = (numerics::Interval(piece.rounding_overhang) *
                              (numerics::Interval(slope) + slope_bound(basis)))
                                 .upper();
  // If a piece of the axis may have the length 0, the slope of its polynomial has no bound.
  if (!(piece.length().lower() > 0)) {
    functions.overhang_error = piece.rounding_overhang > 0 ? HUGE_VAL : 0;
  }
  return functions;
}

std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const ImpactSplineBasis& basis, const VelocityAxisPiece& piece) {
  const bool in = piece.side == VelocityAxisPart::incoming;
  const numerics::Interval r = basis.restitution(),
                           sign_and_scale = in ? numerics::Interval(-1) : 1.0 / r;
  std::vector<numerics::BernsteinCoefficients> slopes = enclose_slopes_of_basis_partial_sums(
      basis.speed_basis(), piece.knot_span, in ? numerics::Interval(-piece.begin) : piece.begin / r,
      in ? numerics::Interval(-piece.end) : piece.end / r);
  for (numerics::BernsteinCoefficients& slope : slopes) {
    for (numerics::Interval& s : slope) s *= sign_and_scale;  // chain rule d/dv = (du/dv) d/du
  }
  return slopes;
}

std::vector<double> basis_break_velocities(const ImpactSplineBasis& basis) {
  const std::span<const double> u = basis.speed_basis().breaks();
  std::vector<double> breaks;
  for (std::size_t i = u.size(); i-- > 0;) breaks.push_back(-u[i]);
  for (std::size_t i = 1; i < u.size(); ++i) breaks.push_back(basis.restitution() * u[i]);
  return breaks;
}

std::vector<VelocityAxisPiece> divide_velocity_axis(const ImpactSplineBasis& basis,
                                                    std::span<const double> cuts,
                                                    double max_length) {
  // A cut of the velocity axis closer than `negligible` to a knot is omitted: The member
  // VelocityAxisPiece::overhang covers the distance between the omitted cut and the knot.
  const double negligible = 4e-16 * basis.speed_basis().end();
  std::vector<VelocityAxisPiece> pieces;
  const auto add_span = [&](VelocityAxisPart side, int span) {
    const auto [begin, end] = velocity_span_ends(basis, side, span);
    std::vector<numerics::Interval> points{begin};
    for (const double cut : cuts) {
      if (cut > points.back().upper() + negligible && cut < end.lower() - negligible) {
        points.emplace_back(cut);
      }
    }
    points.push_back(end);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = points[i + 1].upper() - points[i].lower();
      const int parts = std::max(1, static_cast<int>(std::ceil(length / max_length)));
      numerics::Interval from = points[i];
      for (int part = 1; part <= parts; ++part) {
        const numerics::Interval to =
            part == parts ? points[i + 1]
                          : numerics::Interval(points[i].lower() + length * part / parts);
        pieces.push_back({side, span, from, to, 0});
        from = to;
      }
    }
  };
  for (int s = basis.speed_basis().break_span_count(); s-- > 0;)
    add_span(VelocityAxisPart::incoming, s);
  for (int s = 0; s < basis.speed_basis().break_span_count(); ++s)
    add_span(VelocityAxisPart::outgoing, s);
  return pieces;
}

std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const numerics::SplineBasis& basis, int knot_span, const numerics::Interval& from,
    const numerics::Interval& to) {
  const int p = basis.degree();
  const numerics::SplineBasis lower({basis.breaks().begin(), basis.breaks().end()}, p - 1);
  const auto rows = numerics::bezier_extraction<numerics::Interval>(lower, knot_span, from, to);
  std::vector<numerics::BernsteinCoefficients> slopes;
  for (int l = 1; l <= p; ++l) {
    const numerics::Interval distance =
        numerics::Interval(basis.spline_knot(knot_span + l + p)) - basis.spline_knot(knot_span + l);
    numerics::BernsteinCoefficients slope(rows.row(l - 1).begin(), rows.row(l - 1).end());
    for (numerics::Interval& s : slope) s *= static_cast<double>(p) / distance;
    slopes.push_back(std::move(slope));
  }
  return slopes;
}

}  // namespace fpkcheck::backward
