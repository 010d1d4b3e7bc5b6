#include <algorithm>
#include <cassert>
#include <cfenv>
#include <cmath>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_bounds.hpp"

namespace fpkcheck::backward {
namespace {

// Region of the phase plane outside the box of the splines, in which the residual has one bound.
// The oscillation of the certificate V in v, max_v V - min_v V, is a bound of the change |K V - V|
// by an impulse.
struct RegionOutsideSplineBox {
  numerics::Interval least_energy;  // least energy G in the region
  double max_y_slope, max_v_slope;  // upper bounds of |V_y| and |V_v|
  double max_oscillation;           // upper bound of the oscillation of V in v
};

// Computes outer_residual_bound() as the largest bound over the regions of the phase plane outside
// the box of the splines.
class ResidualBoundOutsideSplineBox {
 public:
  ResidualBoundOutsideSplineBox(const ResidualBoundInputs& inputs,
                                const StationaryFunctional& functional,
                                const BoundCertificate& certificate)
      : inputs_(inputs), functional_(functional), certificate_(certificate) {}

  double bound() const {
    double largest = 0;
    for (int span = 0; span < inputs_.displacement_basis.break_span_count(); ++span) {
      largest =
          std::max({largest, region_bound(region_above(span)), region_bound(region_below(span))});
    }
    for (const bool at_right : {true, false}) {
      if (!(at_right ? inputs_.displacement_ends.is_right_end_open
                     : inputs_.displacement_ends.is_left_end_open))
        continue;
      for (int span = 0; span < inputs_.velocity_basis.speed_basis().break_span_count(); ++span) {
        largest = std::max({largest, region_bound(region_past_end(at_right, span, true)),
                            region_bound(region_past_end(at_right, span, false))});
      }
      largest = std::max(largest, region_bound(corner_region(at_right)));
    }
    return largest;
  }

 private:
  int last_row() const { return static_cast<int>(certificate_.spline_coefficients.rows()) - 1; }
  int last_column() const { return static_cast<int>(certificate_.spline_coefficients.cols()) - 1; }
  numerics::Interval damping() const { return inputs_.residual_weight.damping; }
  numerics::Interval stiffness() const { return inputs_.residual_weight.stiffness; }
  numerics::Interval cubic_stiffness() const { return inputs_.residual_weight.cubic_stiffness; }
  // Reduced stiffness k - c^2/4 > 0 in the energy G, with stiffness k and damping c
  numerics::Interval reduced_stiffness() const { return stiffness() - square(damping()) / 4.0; }
  numerics::Interval restitution() const { return inputs_.velocity_basis.restitution(); }
  numerics::Interval max_speed() const { return inputs_.velocity_basis.speed_basis().end(); }

  // Potential energy (k - c^2/4) y^2/2 + mu y^4/4 in the energy G of the oscillator
  numerics::Interval potential(const numerics::Interval& y) const {
    return reduced_stiffness() * square(y) / 2.0 + cubic_stiffness() * power(y, 4) / 4.0;
  }
  // Returns a bound of the variation over v of the spline sum_b c_ab B_b(v) with index a = row.
  double row_oscillation(int row) const {
    const auto coefficients = certificate_.spline_coefficients.row(row);
    return (numerics::Interval(coefficients.maxCoeff()) - coefficients.minCoeff()).upper();
  }

  // Returns an upper bound of the absolute slope of a spline of degree p on a knot span. The slope
  // of a spline is a convex combination of the coefficients of its derivative, p (c_{i+1} - c_i) /
  // (t_{i+p+1} - t_{i+1}), i = span .. span + p - 1.
  // @param coefficient function that returns the coefficient c_i
  template <class Coefficient>
  static double max_slope(const numerics::SplineBasis& basis, int span,
                          const Coefficient& coefficient) {
    const int p = basis.degree();
    double slope = 0;
    for (int i = span; i < span + p; ++i) {
      const numerics::Interval width =
          numerics::Interval(basis.spline_knot(i + p + 1)) - basis.spline_knot(i + 1);
      slope = std::max(
          slope, magnitude(static_cast<double>(p) *
                           (numerics::Interval(coefficient(i + 1)) - coefficient(i)) / width));
    }
    return slope;
  }

  // Returns the least energy G over all states with |v| >= u and |y| >= `y`. The bound |c v y|/2 <=
  // (c/(2 sqrt k)) (v^2 + k y^2)/2 gives G = (v^2 + k y^2)/2 + c v y/2 + mu y^4/4 >= (1 - c/(2 sqrt
  // k)) (u^2 + k y^2)/2 + mu y^4/4.
  numerics::Interval least_incoming_energy(const numerics::Interval& u,
                                           const numerics::Interval& y) const {
    return (1.0 - damping() / (2.0 * sqrt(stiffness()))) * (square(u) + stiffness() * square(y)) /
               2.0 +
           cubic_stiffness() * power(y, 4) / 4.0;
  }
  // Returns the least energy G over v >= `v` >= 0 and y >= `y` >= 0, or over v <= `v` <= 0 and y <=
  // `y` <= 0. For y v >= 0, |v + c y/2| = |v| + c |y|/2 increases with |v| and with |y|.
  numerics::Interval least_outgoing_energy(const numerics::Interval& v,
                                           const numerics::Interval& y) const {
    return square(v + damping() * y / 2.0) / 2.0 + potential(y);
  }

  // Returns the region beyond the ends of the splines of v, with y in a knot span.
  // @param column index b of the coefficients c_ab of the certificate V in the region
  RegionOutsideSplineBox region_beyond_velocities(int span, int column,
                                                  const numerics::Interval& energy) const {
    RegionOutsideSplineBox region{energy, 0, 0, 0};
    region.max_y_slope = max_slope(inputs_.displacement_basis, span, [&](int a) {
      return certificate_.spline_coefficients(a, column);
    });
    for (int a = span; a <= span + inputs_.displacement_basis.degree(); ++a) {
      region.max_oscillation = std::max(region.max_oscillation, row_oscillation(a));
    }
    return region;
  }
  // Returns the region outside the box of the splines with v > r u_max and y in a knot span.
  RegionOutsideSplineBox region_above(int span) const {
    const double y = inputs_.displacement_basis.breaks()[span];
    return region_beyond_velocities(
        span, last_column(),
        y >= 0 ? least_outgoing_energy(restitution() * max_speed(), y)
               : least_incoming_energy(restitution() * max_speed(), least_displacement(span)));
  }
  // Returns the region outside the box of the splines with v < -u_max and y in a knot span.
  RegionOutsideSplineBox region_below(int span) const {
    return region_beyond_velocities(span, 0,
                                    least_incoming_energy(max_speed(), least_displacement(span)));
  }
  // Returns the least |y| on a knot span.
  double least_displacement(int span) const {
    const auto breaks = inputs_.displacement_basis.breaks();
    return std::max({0.0, breaks[span], -breaks[span + 1]});
  }
  // Returns the distance of an end of the splines of y from the equilibrium y = 0.
  numerics::Interval end_distance(bool at_right) const {
    return at_right ? inputs_.displacement_basis.end()
                    : -inputs_.displacement_basis.breaks().front();
  }
  // Returns the region beyond an open end of the splines of y, with v in a knot span.
  RegionOutsideSplineBox region_past_end(bool at_right, int span, bool outgoing) const {
    const ImpactSplineBasis& velocity = inputs_.velocity_basis;
    const numerics::Interval u = velocity.speed_basis().breaks()[span];
    const numerics::Interval speed = outgoing ? restitution() * u : u, y = end_distance(at_right);
    // At an open end of the splines of y, velocities out of the box point away from y = 0.
    const numerics::Interval energy =
        outgoing == at_right ? least_outgoing_energy(speed, y) : least_incoming_energy(speed, y);
    const int row = at_right ? last_row() : 0;
    const double in_speed = max_slope(velocity.speed_basis(), span, [&](int h) {
      return certificate_.spline_coefficients(
          row, outgoing ? velocity.outgoing_basis_index(h) : velocity.incoming_basis_index(h));
    });
    const double slope =
        outgoing ? (numerics::Interval(in_speed) / restitution()).upper() : in_speed;
    return {energy, 0, slope, row_oscillation(row)};
  }
  // Returns the region beyond the ends of the splines of y and v, with a constant certificate.
  RegionOutsideSplineBox corner_region(bool at_right) const {
    return {potential(end_distance(at_right)), 0, 0, row_oscillation(at_right ? last_row() : 0)};
  }

  // Returns a bound of the weighted residual of a certificate in a region outside the box of the
  // splines. The residual |f + L V - U| of a certificate V is at most a polynomial of degree <= 4 <
  // 2m in the root sqrt(G) of the energy, with coefficients >= 0. With the energy G and the reduced
  // stiffness s, every state satisfies |y| <= sqrt(2G/s) and |v| <= sqrt(2G) (1 + c/(2 sqrt(s))).
  // The ratio of the bound of the residual, a polynomial in sqrt(G), to G^m is largest at the least
  // G.
  double region_bound(const RegionOutsideSplineBox& region) const {
    const double least = region.least_energy.lower();
    if (!(least > 0)) return HUGE_VAL;
    const numerics::Interval root = sqrt(2.0 * numerics::Interval(least)),
                             omega = sqrt(reduced_stiffness());
    const numerics::Interval y = root / omega, v = root * (1.0 + damping() / (2.0 * omega));
    const numerics::Interval force = stiffness() * y + cubic_stiffness() * power(y, 3);
    const numerics::Interval numerator =
        integrand_magnitude_bound(functional_, y, v, force) +
        std::abs(certificate_.approximate_mean) + v * region.max_y_slope +
        (damping() * v + force) * region.max_v_slope +
        numerics::Interval(inputs_.problem.impulses.arrival_rate()) * region.max_oscillation;
    const double bound =
        (numerator / power(numerics::Interval(least) / inputs_.residual_weight.energy_scale,
                           inputs_.residual_weight.exponent))
            .upper();
    return std::isnan(bound) ? HUGE_VAL : bound;  // std::max() would ignore a NaN
  }

  const ResidualBoundInputs& inputs_;
  const StationaryFunctional& functional_;
  const BoundCertificate& certificate_;
};

}  // namespace

double outer_residual_bound(const ResidualBoundInputs& inputs,
                            const StationaryFunctional& functional,
                            const BoundCertificate& certificate) {
  assert(std::fegetround() == FE_UPWARD);
  return ResidualBoundOutsideSplineBox(inputs, functional, certificate).bound();
}

}  // namespace fpkcheck::backward
