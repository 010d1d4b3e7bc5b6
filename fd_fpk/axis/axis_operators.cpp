#include "fd_fpk/axis/axis_operators.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fd_fpk/axis/dense_solve.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// The average of xi^power over [a, b].
double monomial_average(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
}

// Weights w with sum_c w_c avg_c(xi^a) = functional(a) for a < points. The cells c are first ..
// first + points - 1, and xi = (x - origin)/scale.
Eigen::VectorXd exact_weights(const Axis& axis, int first, int points, double origin, double scale,
                              const std::function<double(int)>& functional) {
  Eigen::MatrixXd averages(points, points);
  Eigen::VectorXd wanted(points);
  for (int c = 0; c < points; ++c) {
    const double left = (axis.face(first + c) - origin) / scale;
    const double right = (axis.face(first + c + 1) - origin) / scale;
    for (int a = 0; a < points; ++a) averages(a, c) = monomial_average(left, right, a);
  }
  for (int a = 0; a < points; ++a) wanted(a) = functional(a);
  return dense_solve(averages, wanted);
}

AxisOperator assemble(int rows, int columns, const Triplets& entries) {
  AxisOperator matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Appends the entries of a stencil. Cells outside the axis have p = 0 and no entry.
void append(Triplets& entries, const Axis& axis, int row, int first_cell,
            const Eigen::VectorXd& weights) {
  for (int c = 0; c < weights.size(); ++c) {
    const int cell = first_cell + c;
    if (weights(c) != 0 && cell >= 0 && cell < axis.cells()) {
      entries.emplace_back(row, cell, weights(c));
    }
  }
}

// First cell of a stencil, moved so that the stencil ends at the boundary at the last face or left
// of it.
int clamp_at_right_boundary(const Axis& axis, int first, int points) {
  return axis.right() == EndCondition::boundary ? std::min(first, axis.cells() - points) : first;
}

// First cell of a stencil, moved so that the stencil begins at the boundary at face `limit` or
// right of it.
int clamp_at_left_boundary(const Axis& axis, int first, int limit) {
  return limit > 0 || axis.left() == EndCondition::boundary ? std::max(first, limit) : first;
}

// The matrix that applies a functional (value or derivative at xi = 0) on every inner face, with
// the local coordinate xi = (x - x_face)/width; the result is divided by width^derivative.
AxisOperator inner_face_operator(const Axis& axis, int points, Bias bias, int derivative,
                                 const std::function<double(int)>& functional) {
  Triplets entries;
  const int upstream = bias == Bias::left ? (points + 1) / 2 : points / 2;
  for (int f = 1; f < axis.cells(); ++f) {
    const int first =
        clamp_at_right_boundary(axis, clamp_at_left_boundary(axis, f - upstream, 0), points);
    const double width = axis.width(f);
    append(entries, axis, f, first,
           exact_weights(axis, first, points, axis.face(f), width, functional) /
               std::pow(width, derivative));
  }
  return assemble(axis.cells() + 1, axis.cells(), entries);
}

// The first cell of the stencil for cell i, moved so that the stencil does not cross the barrier.
int first_stencil_cell(const Axis& axis, int i, int points, std::optional<int> barrier) {
  const bool beyond = barrier && i >= *barrier;
  int first = clamp_at_left_boundary(axis, i - points / 2, beyond ? *barrier : 0);
  if (barrier && !beyond) first = std::min(first, *barrier - points);
  return clamp_at_right_boundary(axis, first, points);
}

double value_at_zero(int a) { return a == 0 ? 1.0 : 0.0; }
double slope_at_zero(int a) { return a == 1 ? 1.0 : 0.0; }

}  // namespace

AxisOperator face_values(const Axis& axis, int points, Bias bias) {
  return inner_face_operator(axis, points, bias, 0, value_at_zero);
}

AxisOperator face_derivatives(const Axis& axis, int points) {
  return inner_face_operator(axis, points, Bias::left, 1, slope_at_zero);
}

AxisOperator first_face_value(const Axis& axis, int points) {
  Triplets entries;
  append(entries, axis, 0, 0,
         exact_weights(axis, 0, points, axis.face(0), axis.width(0), value_at_zero));
  return assemble(1, axis.cells(), entries);
}

AxisOperator last_face_value(const Axis& axis, int points) {
  Triplets entries;
  const int last = axis.cells();
  append(entries, axis, 0, last - points,
         exact_weights(axis, last - points, points, axis.face(last), axis.width(last - 1),
                       value_at_zero));
  return assemble(1, axis.cells(), entries);
}

AxisOperator weighted_averages(const Axis& axis, int points, const numerics::Polynomial& weight,
                               std::optional<int> barrier) {
  Triplets entries;
  const std::size_t degree = weight.degree();
  for (int i = 0; i < axis.cells(); ++i) {
    const int first = first_stencil_cell(axis, i, points, barrier);
    // The expansion weight(x_i + h_i xi) = sum_q local[q] xi^q, by repeated Horner division.
    auto local = weight.coefficients();
    for (std::size_t q = 0; q <= degree; ++q) {
      for (std::size_t s = degree; s-- > q;) local[s] += axis.centre(i) * local[s + 1];
    }
    for (std::size_t q = 0; q <= degree; ++q) local[q] *= std::pow(axis.width(i), q);
    const auto functional = [&](int a) {
      double sum = 0;
      for (std::size_t q = 0; q <= degree; ++q) {
        sum += local[q] * monomial_average(-0.5, 0.5, a + static_cast<int>(q));
      }
      return sum;
    };
    append(entries, axis, i, first,
           exact_weights(axis, first, points, axis.centre(i), axis.width(i), functional));
  }
  return assemble(axis.cells(), axis.cells(), entries);
}

AxisOperator point_values(const Axis& axis, int points, std::span<const double> fractions,
                          std::optional<int> barrier) {
  Triplets entries;
  const int of_cell = static_cast<int>(fractions.size());
  for (int i = 0; i < axis.cells(); ++i) {
    const int first = first_stencil_cell(axis, i, points, barrier);
    for (int k = 0; k < of_cell; ++k) {
      const double xi = fractions[k] - 0.5;
      const auto value = [xi](int a) { return std::pow(xi, a); };
      append(entries, axis, i * of_cell + k, first,
             exact_weights(axis, first, points, axis.centre(i), axis.width(i), value));
    }
  }
  return assemble(of_cell * axis.cells(), axis.cells(), entries);
}

AxisOperator divergence(const Axis& axis) {
  Triplets entries;
  for (int i = 0; i < axis.cells(); ++i) {
    entries.emplace_back(i, i, -1 / axis.width(i));
    entries.emplace_back(i, i + 1, 1 / axis.width(i));
  }
  return assemble(axis.cells(), axis.cells() + 1, entries);
}

}  // namespace fpkcheck::fd_fpk
