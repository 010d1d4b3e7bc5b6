#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "backward/passage/unforced_motion.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Functions on the phase plane below a barrier that are smooth in sqrt(barrier - y) and in v, by
/// their values at the tensor product of Chebyshev nodes. Outside its domain a function is constant
/// along y and along v.
class ChebyshevPlane {
 public:
  struct Domain {
    double y_low, barrier, v_max;
  };
  ChebyshevPlane(const Domain& domain, int n_y, int n_v);

  int n_y() const { return static_cast<int>(y_.size()); }
  int n_v() const { return static_cast<int>(v_.size()); }
  Eigen::Index size() const { return y_.size() * v_.size(); }
  const Domain& domain() const { return domain_; }
  double y_node(int i) const { return domain_.barrier - y_.nodes(i) * y_.nodes(i); }
  double v_node(int j) const { return v_.nodes(j); }
  /// Position of the value at the node (i, j) in a vector of values
  Eigen::Index index(int i, int j) const { return i * v_.size() + j; }

  /// Values of the Lagrange polynomials of the nodes in y, or in v. The interpolated value at (y,
  /// v) is in_y(y)^T G in_v(v), with the matrix G of the values, of shape (n_y, n_v).
  void in_y(double y, Eigen::Ref<Eigen::VectorXd> values) const;
  void in_v(double v, Eigen::Ref<Eigen::VectorXd> values) const;

 private:
  struct Interpolation {
    Eigen::VectorXd nodes, weights;  // Chebyshev nodes and their barycentric weights

    Interpolation(double low, double high, int count);
    Eigen::Index size() const { return nodes.size(); }
    void lagrange_values(double x, Eigen::Ref<Eigen::VectorXd> values) const;
  };
  Domain domain_;
  Interpolation y_, v_;  // y_: in sqrt(barrier - y)
};

/// A weight t^power exp(-rate t) of the time t since the last impulse.
struct TimeWeight {
  double rate;
  int power = 0;
};

/// The mean over an impulse Y of integrals along the motion after the impulse,
///
///     (A f)(y, v) = E int_0^te w(t) f(X_t) dt,   X_0 = (y, v + Y),
///
/// where te is the time of the passage of the barrier without a further impulse. For w =
/// exp(-lambda t) the function h = E T(y, v + Y) of the mean time T to the passage satisfies h = A
/// 1 + lambda A h (renewal equation). Collocation represents f and A f on a ChebyshevPlane.
class RenewalEquation {
 public:
  /// @param slowest_rate least rate of the weights of operators() and from_state()
  /// @param refinement divides the panels of time and of velocity
  /// @pre the impulses have a law with a density, and no factor
  RenewalEquation(const problem::Problem& problem, const ChebyshevPlane& plane, double slowest_rate,
                  double refinement);

  struct Operator {
    Eigen::MatrixXd of_function;  ///< matrix of A, shape (plane.size(), plane.size())
    Eigen::VectorXd of_one;       ///< values of A 1
  };
  /// Returns the operators of several weights; no operators if the deadline passes.
  std::vector<Operator> operators(const std::vector<TimeWeight>& weights,
                                  const base::Deadline& deadline) const;

  /// Functional f -> int_0^te w(t) f(X_t) dt of the motion from a state.
  struct Functional {
    Eigen::VectorXd of_function;  ///< weights of the values of f
    double of_one;                ///< integral of w
  };
  Functional from_state(const PhaseState& from, const TimeWeight& weight) const;

 private:
  struct VelocityRule {
    std::vector<double> points;
    Eigen::MatrixXd weights;  // of the values at the points, for each node in v
  };
  VelocityRule velocity_rule(double y) const;
  std::vector<double> singular_velocities(double y) const;
  void integrate(const Motion& motion, const std::vector<TimeWeight>& weights,
                 Eigen::Ref<Eigen::MatrixXd> of_function, Eigen::Ref<Eigen::VectorXd> of_one) const;

  problem::Problem problem_;
  ChebyshevPlane plane_;
  double refinement_;
  UnforcedMotion motion_;
  double longest_;                         // time limit of motions: the weights are then 1.5e-8
  double lowest_change_, highest_change_;  // range of the amplitudes
};

/// Returns the range of amplitudes outside of which the probability is below 1e-9.
std::array<double, 2> amplitude_range(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::backward
