#include "fd_fpk/line/line_operators.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fd_fpk/line/dense_solve.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Average of xi^power over [a, b].
double monomial_average(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
}

// Weights w with sum_c w_c avg_c(xi^a) = functional(a) for a < points. The cells c are first ..
// first + points - 1, and xi = (x - origin)/scale.
Eigen::VectorXd exact_weights(const Line& line, int first, int points, double origin, double scale,
                              const std::function<double(int)>& functional) {
  Eigen::MatrixXd averages(points, points);
  Eigen::VectorXd wanted(points);
  for (int c = 0; c < points; ++c) {
    const double left = (line.face(first + c) - origin) / scale;
    const double right = (line.face(first + c + 1) - origin) / scale;
    for (int a = 0; a < points; ++a) averages(a, c) = monomial_average(left, right, a);
  }
  for (int a = 0; a < points; ++a) wanted(a) = functional(a);
  return dense_solve(averages, wanted);
}

LineOperator assemble(int rows, int columns, const Triplets& entries) {
  LineOperator matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Cells outside the axis have p = 0.
void append(Triplets& entries, const Line& line, int row, int first_cell,
            const Eigen::VectorXd& weights) {
  for (int c = 0; c < weights.size(); ++c) {
    const int cell = first_cell + c;
    if (weights(c) != 0 && cell >= 0 && cell < line.cells()) {
      entries.emplace_back(row, cell, weights(c));
    }
  }
}

// Moves a stencil inwards of a boundary at the last face.
int not_beyond(const Line& line, int first, int points) {
  return line.right() == Beyond::boundary ? std::min(first, line.cells() - points) : first;
}

// Moves a stencil to the right of a boundary at face `limit`.
int not_before(const Line& line, int first, int limit) {
  return limit > 0 || line.left() == Beyond::boundary ? std::max(first, limit) : first;
}

// A functional of the local coordinate xi = (x - x_face)/width on every inner face, divided by
// width^derivative.
LineOperator on_inner_faces(const Line& line, int points, Bias bias, int derivative,
                            const std::function<double(int)>& functional) {
  Triplets entries;
  const int upstream = bias == Bias::left ? (points + 1) / 2 : points / 2;
  for (int f = 1; f < line.cells(); ++f) {
    const int first = not_beyond(line, not_before(line, f - upstream, 0), points);
    const double width = line.width(f);
    append(entries, line, f, first,
           exact_weights(line, first, points, line.face(f), width, functional) /
               std::pow(width, derivative));
  }
  return assemble(line.cells() + 1, line.cells(), entries);
}

// The first cell of a stencil around cell i that does not cross the barrier.
int first_about(const Line& line, int i, int points, std::optional<int> barrier) {
  const bool beyond = barrier && i >= *barrier;
  int first = not_before(line, i - points / 2, beyond ? *barrier : 0);
  if (barrier && !beyond) first = std::min(first, *barrier - points);
  return not_beyond(line, first, points);
}

double value_at_zero(int a) { return a == 0 ? 1.0 : 0.0; }
double slope_at_zero(int a) { return a == 1 ? 1.0 : 0.0; }

}  // namespace

LineOperator face_values(const Line& line, int points, Bias bias) {
  return on_inner_faces(line, points, bias, 0, value_at_zero);
}

LineOperator face_derivatives(const Line& line, int points) {
  return on_inner_faces(line, points, Bias::left, 1, slope_at_zero);
}

LineOperator end_value(const Line& line, int points) {
  Triplets entries;
  append(entries, line, 0, 0,
         exact_weights(line, 0, points, line.face(0), line.width(0), value_at_zero));
  return assemble(1, line.cells(), entries);
}

LineOperator last_value(const Line& line, int points) {
  Triplets entries;
  const int last = line.cells();
  append(entries, line, 0, last - points,
         exact_weights(line, last - points, points, line.face(last), line.width(last - 1),
                       value_at_zero));
  return assemble(1, line.cells(), entries);
}

LineOperator weighted_averages(const Line& line, int points, const numerics::Polynomial& weight,
                               std::optional<int> barrier) {
  Triplets entries;
  const std::size_t degree = weight.degree();
  for (int i = 0; i < line.cells(); ++i) {
    const int first = first_about(line, i, points, barrier);
    // weight(x_i + h_i xi) = sum_q local[q] xi^q, by repeated Horner division
    auto local = weight.coefficients();
    for (std::size_t q = 0; q <= degree; ++q) {
      for (std::size_t s = degree; s-- > q;) local[s] += line.centre(i) * local[s + 1];
    }
    for (std::size_t q = 0; q <= degree; ++q) local[q] *= std::pow(line.width(i), q);
    const auto functional = [&](int a) {
      double sum = 0;
      for (std::size_t q = 0; q <= degree; ++q) {
        sum += local[q] * monomial_average(-0.5, 0.5, a + static_cast<int>(q));
      }
      return sum;
    };
    append(entries, line, i, first,
           exact_weights(line, first, points, line.centre(i), line.width(i), functional));
  }
  return assemble(line.cells(), line.cells(), entries);
}

LineOperator point_values(const Line& line, int points, std::span<const double> fractions,
                          std::optional<int> barrier) {
  Triplets entries;
  const int of_cell = static_cast<int>(fractions.size());
  for (int i = 0; i < line.cells(); ++i) {
    const int first = first_about(line, i, points, barrier);
    for (int k = 0; k < of_cell; ++k) {
      const double xi = fractions[k] - 0.5;
      const auto value = [xi](int a) { return std::pow(xi, a); };
      append(entries, line, i * of_cell + k, first,
             exact_weights(line, first, points, line.centre(i), line.width(i), value));
    }
  }
  return assemble(of_cell * line.cells(), line.cells(), entries);
}

LineOperator divergence(const Line& line) {
  Triplets entries;
  for (int i = 0; i < line.cells(); ++i) {
    entries.emplace_back(i, i, -1 / line.width(i));
    entries.emplace_back(i, i + 1, 1 / line.width(i));
  }
  return assemble(line.cells(), line.cells() + 1, entries);
}

}  // namespace fpkcheck::fd_fpk
