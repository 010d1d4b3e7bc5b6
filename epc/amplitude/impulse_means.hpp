#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "epc/half_plane/basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// Possible velocities after an impulse, and the probability of each velocity.
struct PostImpulseVelocities {
  std::vector<double> v, probability;
};

/// Quadrature rule for E[f(v + Y)], the mean of a function f after an impulse Y: the sum of f over
/// the velocities `v`, weighted by `probability`. The function f is smooth on either side of
/// velocity 0 and varies near 0 over a given width. For rho and theta at a given y, this width is
/// w(y). The atoms of the law of Y enter exactly. The density of the law is integrated by
/// Gauss-Legendre panels between its break points; the panels are graded towards velocity 0.
class GradedImpulseQuadrature {
 public:
  explicit GradedImpulseQuadrature(const problem::ImpulseLaw& law);

  /// Velocities and probabilities after an impulse at velocity v. The returned reference is valid
  /// until the next call.
  /// @param width width of the variation of f near velocity 0; 0 for a function f that is smooth up
  ///        to velocity 0 on either side
  const PostImpulseVelocities& operator()(double v, double width);

 private:
  void add_panel(double from, double to, double v);

  const problem::ImpulseLaw& law_;
  std::vector<double> pieces_;
  std::vector<problem::AmplitudeAtom> atoms_;
  std::vector<double> breaks_;
  PostImpulseVelocities after_;
};

/// Function that returns the coordinates s and t of QuadraturePoints from w = sqrt(2 V(y)) and a
/// velocity v.
using CoordinateMap = std::function<std::pair<double, double>(double w, double v)>;

/// Means E[phi(y, v + Y)] of every basis function phi after an impulse Y. The returned matrix has
/// the shape (number of points, number of basis functions). Near v = 0 the basis functions vary
/// over a width w, see GradedImpulseQuadrature.
/// @param w,v values of w and v at the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law, const half_plane::Basis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const CoordinateMap& coordinates);

}  // namespace fpkcheck::epc::amplitude
