#include <algorithm>
#include <cassert>
#include <cfenv>
#include <cmath>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_bounds.hpp"

namespace fpkcheck::backward {
namespace {

// A region outside the box of the splines, with the least energy G, bounds of the slopes of the
// certificate V, and a bound of the oscillation of V in v.
struct Region {
  numerics::Interval energy;
  double y_slope, v_slope, oscillation;
};

class OuterResidual {
 public:
  OuterResidual(const CertificateCheckInputs& context, const Functional& functional,
                const Certificate& certificate)
      : s_(context), functional_(functional), certificate_(certificate) {}

  double bound() const {
    double largest = 0;
    for (int span = 0; span < s_.displacement.span_count(); ++span) {
      largest =
          std::max({largest, region_bound(region_above(span)), region_bound(region_below(span))});
    }
    for (const bool at_right : {true, false}) {
      if (!(at_right ? s_.ends.right_open : s_.ends.left_open)) continue;
      for (int span = 0; span < s_.velocity.speeds().span_count(); ++span) {
        largest = std::max({largest, region_bound(region_past_end(at_right, span, true)),
                            region_bound(region_past_end(at_right, span, false))});
      }
      largest = std::max(largest, region_bound(corner_region(at_right)));
    }
    return largest;
  }

 private:
  int last_row() const { return static_cast<int>(certificate_.coefficients.rows()) - 1; }
  int last_column() const { return static_cast<int>(certificate_.coefficients.cols()) - 1; }
  numerics::Interval c() const { return s_.weight.damping; }
  numerics::Interval k() const { return s_.weight.stiffness; }
  numerics::Interval cubic() const { return s_.weight.cubic; }
  // positive reduced stiffness k - c^2/4
  numerics::Interval stiffness() const { return k() - square(c()) / 4.0; }
  numerics::Interval r() const { return s_.velocity.restitution(); }
  numerics::Interval u_end() const { return s_.velocity.speeds().end(); }

  // potential energy (k - c^2/4) y^2/2 + mu y^4/4
  numerics::Interval potential(const numerics::Interval& y) const {
    return stiffness() * square(y) / 2.0 + cubic() * power(y, 4) / 4.0;
  }
  double oscillation(int row) const {
    const auto coefficients = certificate_.coefficients.row(row);
    return (numerics::Interval(coefficients.maxCoeff()) - coefficients.minCoeff()).upper();
  }

  // Returns the largest absolute slope of a spline on a span. The slope is a convex combination of
  // the coefficients of the derivative, p (c_{i+1} - c_i) / (t_{i+p+1} - t_{i+1}), with i = span ..
  // span + p - 1.
  template <class Coefficient>
  static double max_slope(const numerics::SplineBasis& basis, int span,
                          const Coefficient& coefficient) {
    const int p = basis.degree();
    double slope = 0;
    for (int i = span; i < span + p; ++i) {
      const numerics::Interval width =
          numerics::Interval(basis.knot(i + p + 1)) - basis.knot(i + 1);
      slope = std::max(
          slope, magnitude(static_cast<double>(p) *
                           (numerics::Interval(coefficient(i + 1)) - coefficient(i)) / width));
    }
    return slope;
  }

  // Returns the least energy G for |v| >= u and |y| >= `y`. The bound |c v y|/2 <= (c/(2 sqrt k))
  // (v^2 + k y^2)/2 gives G = (v^2 + k y^2)/2 + c v y/2 + mu y^4/4 >= (1 - c/(2 sqrt k)) (u^2 + k
  // y^2)/2 + mu y^4/4.
  numerics::Interval least_incoming_energy(const numerics::Interval& u,
                                           const numerics::Interval& y) const {
    return (1.0 - c() / (2.0 * sqrt(k()))) * (square(u) + k() * square(y)) / 2.0 +
           cubic() * power(y, 4) / 4.0;
  }
  // Returns the least energy G for v >= `v` >= 0 and y >= `y` >= 0, or for v <= `v` <= 0 and y <=
  // `y` <= 0. In these regions |w| = |v| + c |y|/2 increases with |v| and with |y|.
  numerics::Interval least_outgoing_energy(const numerics::Interval& v,
                                           const numerics::Interval& y) const {
    return square(v + c() * y / 2.0) / 2.0 + potential(y);
  }

  Region region_beside(int span, int column, const numerics::Interval& energy) const {
    Region region{energy, 0, 0, 0};
    region.y_slope = max_slope(s_.displacement, span,
                               [&](int a) { return certificate_.coefficients(a, column); });
    for (int a = span; a <= span + s_.displacement.degree(); ++a) {
      region.oscillation = std::max(region.oscillation, oscillation(a));
    }
    return region;
  }
  // Returns the region outside the box with velocities v > r u_end and with y in a knot span.
  Region region_above(int span) const {
    const double y = s_.displacement.breaks()[span];
    return region_beside(span, last_column(),
                         y >= 0 ? least_outgoing_energy(r() * u_end(), y)
                                : least_incoming_energy(r() * u_end(), least_displacement(span)));
  }
  // Returns the region outside the box with velocities v < -u_end and with y in a knot span.
  Region region_below(int span) const {
    return region_beside(span, 0, least_incoming_energy(u_end(), least_displacement(span)));
  }
  double least_displacement(int span) const {
    const auto breaks = s_.displacement.breaks();
    return std::max({0.0, breaks[span], -breaks[span + 1]});
  }
  numerics::Interval end(bool at_right) const {
    return at_right ? s_.displacement.end() : -s_.displacement.breaks().front();
  }
  // Returns the region beyond an open end of the box in y, with v in a knot span.
  Region region_past_end(bool at_right, int span, bool outgoing) const {
    const ImpactBasis& velocity = s_.velocity;
    const numerics::Interval u = velocity.speeds().breaks()[span];
    const numerics::Interval speed = outgoing ? r() * u : u, y = end(at_right);
    // Outgoing velocities point away from y = 0: at the right end v >= 0.
    const numerics::Interval energy =
        outgoing == at_right ? least_outgoing_energy(speed, y) : least_incoming_energy(speed, y);
    const int row = at_right ? last_row() : 0;
    const double in_speed = max_slope(velocity.speeds(), span, [&](int h) {
      return certificate_.coefficients(
          row, outgoing ? velocity.outgoing_index(h) : velocity.incoming_index(h));
    });
    const double slope = outgoing ? (numerics::Interval(in_speed) / r()).upper() : in_speed;
    return {energy, 0, slope, oscillation(row)};
  }
  // Returns the region beyond the ends of the box in y and in v, where the certificate V is
  // constant.
  Region corner_region(bool at_right) const {
    return {potential(end(at_right)), 0, 0, oscillation(at_right ? last_row() : 0)};
  }

  // The residual |f + L V - U| is at most a polynomial in sqrt(G) of degree <= 4 < 2m with
  // coefficients >= 0, since |y| <= sqrt(2G/stiffness) and |v| <= sqrt(2G) (1 + c/(2
  // sqrt(stiffness))). The ratio of the polynomial to G^m is largest at the least energy G.
  double region_bound(const Region& region) const {
    const double least = region.energy.lower();
    if (!(least > 0)) return HUGE_VAL;
    const numerics::Interval root = sqrt(2.0 * numerics::Interval(least)),
                             omega = sqrt(stiffness());
    const numerics::Interval y = root / omega, v = root * (1.0 + c() / (2.0 * omega));
    const numerics::Interval force = k() * y + cubic() * power(y, 3);
    const numerics::Interval numerator =
        integrand_magnitude_bound(functional_, y, v, force) + std::abs(certificate_.mean) +
        v * region.y_slope + (c() * v + force) * region.v_slope +
        numerics::Interval(s_.problem.impulses.arrival_rate()) * region.oscillation;
    const double bound =
        (numerator / power(numerics::Interval(least) / s_.weight.scale, s_.weight.power)).upper();
    return std::isnan(bound) ? HUGE_VAL : bound;  // the maximum of std::max would ignore NaN
  }

  const CertificateCheckInputs& s_;
  const Functional& functional_;
  const Certificate& certificate_;
};

}  // namespace

double outer_residual_bound(const CertificateCheckInputs& context, const Functional& functional,
                            const Certificate& certificate) {
  assert(std::fegetround() == FE_UPWARD);
  return OuterResidual(context, functional, certificate).bound();
}

}  // namespace fpkcheck::backward
