#pragma once

#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

/// Splines of v on [-u_max, r u_max], constant beyond these ends. The incoming side, v = -u, and
/// the outgoing side, v = r u, have the same splines of the impact speed u. The two sides are
/// joined continuously at v = 0 (an inner knot of full multiplicity). If the coefficients of `b`
/// and `mirrored_index(b)` are equal at y = 0, the impact condition V(0, r u) = V(0, -u) therefore
/// holds exactly for all u, even if r u is rounded.
class ImpactBasis {
 public:
  ImpactBasis(numerics::SplineBasis speeds, double restitution)
      : speeds_(std::move(speeds)), restitution_(restitution) {}

  const numerics::SplineBasis& speeds() const { return speeds_; }
  double restitution() const { return restitution_; }
  int size() const { return 2 * speeds_.size() - 1; }
  /// Index of the only function that does not vanish at v = 0.
  int centre_index() const { return speeds_.size() - 1; }
  int mirrored_index(int b) const { return size() - 1 - b; }
  /// Indices of the spline with index h of the speed, on the incoming and on the outgoing side.
  int incoming_index(int h) const { return centre_index() - h; }
  int outgoing_index(int h) const { return centre_index() + h; }
  double begin() const { return -speeds_.end(); }
  double end() const { return restitution_ * speeds_.end(); }

 private:
  numerics::SplineBasis speeds_;
  double restitution_;
};

}  // namespace fpkcheck::backward
