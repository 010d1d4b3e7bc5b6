#pragma once

#include "numerics/splines/basis.hpp"

namespace fpkcheck::backward {

/// Splines of v on [-u_max, r u_max], continued as constants beyond. Incoming, v = -u, and
/// outgoing, v = r u, are the same splines of the impact speed u, joined continuously at v = 0 (an
/// inner knot of full multiplicity). So the impact condition V(0, r u) = V(0, -u) holds exactly,
/// for all u, when at y = 0 the coefficients of `b` and `mirrored(b)` are equal, whatever the
/// rounding of r u.
class ImpactBasis {
 public:
  ImpactBasis(numerics::SplineBasis speeds, double restitution)
      : speeds_(std::move(speeds)), restitution_(restitution) {}

  const numerics::SplineBasis& speeds() const { return speeds_; }
  double restitution() const { return restitution_; }
  int size() const { return 2 * speeds_.size() - 1; }
  /// The function that is not zero at v = 0.
  int centre() const { return speeds_.size() - 1; }
  int mirrored(int b) const { return size() - 1 - b; }
  /// Function h of the speed on the incoming or on the outgoing side.
  int incoming(int h) const { return centre() - h; }
  int outgoing(int h) const { return centre() + h; }
  double begin() const { return -speeds_.end(); }
  double end() const { return restitution_ * speeds_.end(); }

 private:
  numerics::SplineBasis speeds_;
  double restitution_;
};

}  // namespace fpkcheck::backward
