#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "problem/expression/expression.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::problem {

/// A formula of the physical displacement y and velocity y' as a function of wall coordinates.
class StateFunction {
 public:
  explicit StateFunction(Expression formula)
      : formula_(std::make_shared<const Expression>(std::move(formula))) {}

  double operator()(double x, double v) const {
    return (*formula_)(frame_.physical_y(x), frame_.physical_velocity(v));
  }
  /// Returns the value of the formula, and the derivative with respect to the displacement in wall
  /// coordinates.
  numerics::DualNumber with_slope_in_x(double x, double v) const {
    return (*formula_)(numerics::DualNumber{frame_.physical_y(x), frame_.velocity_sign()},
                       numerics::DualNumber{frame_.physical_velocity(v), 0});
  }
  /// Returns the value of the formula, and the derivative with respect to the velocity in wall
  /// coordinates.
  numerics::DualNumber with_slope_in_v(double x, double v) const {
    return (*formula_)(numerics::DualNumber{frame_.physical_y(x), 0},
                       numerics::DualNumber{frame_.physical_velocity(v), frame_.velocity_sign()});
  }
  /// Computes the values of the formula at `count` <= Expression::kBatchPoints points, faster than
  /// by single evaluations.
  void evaluate_batch(std::size_t count, const double* x, const double* v, double* values) const;
  /// Computes the values of the formula, and the derivatives with respect to the velocity in wall
  /// coordinates, at `count` <= Expression::kBatchPoints points.
  void evaluate_batch_with_velocity_slopes(std::size_t count, const double* x, const double* v,
                                           double* values, double* slopes) const;

  /// Returns the formula in physical coordinates.
  const Expression& formula() const { return *formula_; }
  /// Returns the values of the wall coordinate x in (low, high) at which the function or its slope
  /// jumps, in increasing order.
  std::vector<double> kinks_in_x(double low, double high) const;
  /// Returns the velocities in (low, high), in wall coordinates, at which the function or its slope
  /// jumps, in increasing order.
  std::vector<double> kinks_in_v(double low, double high) const;

  /// Returns the formula as a function of the wall coordinates of `frame`.
  /// @pre the function is in physical coordinates
  StateFunction to_wall_coordinates(const WallFrame& frame) const;

 private:
  using Batch = std::array<double, Expression::kBatchPoints>;
  struct PhysicalStates {
    Batch y{}, v{};
  };
  PhysicalStates physical_states(std::size_t count, const double* x, const double* v) const;

  std::shared_ptr<const Expression> formula_;
  WallFrame frame_;
};

}  // namespace fpkcheck::problem
