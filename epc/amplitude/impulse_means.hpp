#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "epc/half_plane/half_plane_basis.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

struct VelocitiesAfterImpulse {
  std::vector<double> v, probability;
};

/// Quadrature rule for the mean E[f(v + Y)] of a function f after an impulse Y. The function f of
/// the velocity is smooth on either side of velocity 0, and varies near velocity 0 over a given
/// width, which is w(y) = sqrt(2 V(y)) for the coordinates amplitude and phase. Atoms of the law of
/// Y are summed exactly. The density of the impulse law is integrated by Gauss-Legendre panels,
/// which become narrower towards velocity 0.
class GradedImpulseQuadrature {
 public:
  explicit GradedImpulseQuadrature(const problem::ImpulseLaw& law);

  /// Returns quadrature points and probabilities of the velocity after an impulse at the velocity
  /// v. The returned reference is valid until the next call of the function.
  /// @param width width over which f varies near velocity 0, or 0 if f is smooth up to velocity 0
  ///   on either side
  const VelocitiesAfterImpulse& operator()(double v, double width);

 private:
  void add_quadrature_panel(double from, double to, double v);

  const problem::ImpulseLaw& law_;
  std::vector<double> pieces_;
  std::vector<problem::AmplitudeAtom> atoms_;
  std::vector<double> breaks_;
  VelocitiesAfterImpulse after_;
};

/// Maps w = sqrt(2 V(y)) and a velocity v to the coordinates s and t of QuadraturePoints.
using CoordinatesOfPhasePoint = std::function<std::pair<double, double>(double w, double v)>;

/// Returns the means E[phi(y, v + Y)] of all basis functions phi after an impulse Y, of shape
/// (number of points, number of basis functions).
/// @param w,v values of w = sqrt(2 V(y)) and v at the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law,
                                    const half_plane::OrthonormalBasis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const CoordinatesOfPhasePoint& coordinates);

}  // namespace fpkcheck::epc::amplitude
