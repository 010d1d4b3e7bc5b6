#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Returns the polynomial of the effective potential V = U - lambda E[Y] y, the sum of the
/// potential U of the spring and the potential of the mean force of the impulses.
/// @pre problem.system.has_polynomial_force()
numerics::Polynomial effective_potential_polynomial(const Problem& problem);

/// Returns the points between the walls where a polynomial changes its sign, in increasing order.
std::vector<double> polynomial_sign_changes_between_walls(const numerics::Polynomial& polynomial,
                                                          const System& system);

/// The effective potential V = U - lambda E[Y] y, a polynomial or the integral of a formula.
class EffectivePotential {
 public:
  explicit EffectivePotential(const Problem& problem);
  /// Constructs the potential V = U of the spring alone, without the mean force of impulses.
  explicit EffectivePotential(const System& system);

  double operator()(double y) const {
    return polynomial_ ? (*polynomial_)(y) : integrate_force_up_to(y);
  }
  /// Returns the polynomial of the effective potential V; null for a force by a formula.
  const numerics::Polynomial* polynomial_or_null() const {
    return polynomial_ ? &*polynomial_ : nullptr;
  }
  /// Returns the slope V'(y) of the effective potential.
  double potential_slope(double y) const {
    return polynomial_ ? slope_polynomial_(y) : system_.force(y, 0) - mean_force_;
  }
  /// Returns the displacements of the extrema of the potential V between the walls, in increasing
  /// order. For a force by a formula, the search can miss two extrema whose distance from each
  /// other is below 1/8 of their distance from y = 0.
  const std::vector<double>& extremum_positions() const { return extrema_; }
  /// Return whether the effective potential V increases without bound towards the left, and towards
  /// the right.
  bool is_unbounded_on_left() const { return is_unbounded_on_left_; }
  bool is_unbounded_on_right() const { return is_unbounded_on_right_; }
  /// Return the ends of an interval that contains all extrema of the effective potential: the
  /// walls, or points outside the extrema.
  double y_low() const { return low_; }
  double y_high() const { return high_; }

 private:
  void tabulate_potential();
  double integrate_force_up_to(double y) const;

  System system_;
  double mean_force_;  // lambda E[Y]
  std::optional<numerics::Polynomial> polynomial_;
  numerics::Polynomial slope_polynomial_{{}};
  std::vector<double> knots_, values_;  // V of a formula at the knots, increasing
  std::vector<double> extrema_;
  double low_ = 0, high_ = 0;
  bool is_unbounded_on_left_ = false, is_unbounded_on_right_ = false;
};

/// Returns the displacement at which the mass rests without excitation: the left wall, if no force
/// lifts the mass off the wall, otherwise the lowest minimum of the spring's potential below
/// `y_limit`. With `lower_limit` only displacements above this limit count. The rest displacement is empty if the mass has no position of rest below `y_limit`,
/// or if the excitation vanishes at the position of rest, so that the mass would stay at rest.
std::optional<double> rest_displacement(const Problem& problem, double y_limit,
                                        const std::optional<double>& lower_limit = {});

}  // namespace fpkcheck::problem
