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
/// the velocity is smooth on either side of velocity 0, and varies near velocity 0 over the given
/// width. The mean over the atoms of the impulse law is an exact sum. The mean over the density of
/// the impulse law is computed on Gauss-Legendre panels, which become narrower towards velocity 0.
class GradedImpulseQuadrature {
 public:
  explicit GradedImpulseQuadrature(const problem::ImpulseLaw& law);

  /// Returns quadrature points and probabilities of the velocity v + Y after an impulse Y at the
  /// velocity v. The returned quadrature points are valid until the next call of the function.
  /// @param width range of velocities near 0 in which the integrand f varies, or 0 if f is smooth
  ///   on either side of velocity 0
  const VelocitiesAfterImpulse& operator()(double v, double width);

 private:
  void add_quadrature_panel(double from, double to, double v);

  const problem::ImpulseLaw& law_;
  std::vector<double> pieces_;
  std::vector<problem::AmplitudeAtom> atoms_;
  std::vector<double> breaks_;
  VelocitiesAfterImpulse after_;
};

/// Maps w = sqrt(2 V(y)), with potential V, and the velocity v to coordinates s and t of a closure.
using CoordinatesOfPhasePoint = std::function<std::pair<double, double>(double w, double v)>;

/// Returns the means E[phi(y, v + Y)] of all basis functions phi after an impulse Y, in a matrix of
/// shape (points, basis functions).
/// @param w,v values of sqrt(2 V(y)) and of the velocity v at the points
Eigen::MatrixXd means_after_impulse(const problem::ImpulseLaw& law,
                                    const half_plane::OrthonormalBasis& basis,
                                    const Eigen::VectorXd& w, const Eigen::VectorXd& v,
                                    const CoordinatesOfPhasePoint& coordinates);

}  // namespace fpkcheck::epc::amplitude
