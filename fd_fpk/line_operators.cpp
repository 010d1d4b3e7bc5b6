#include "fd_fpk/line_operators.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

namespace fpkcheck::fd_fpk {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Average of xi^power over [a, b].
double monomial_average(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
}

// Weights w with sum_c w_c avg_c(xi^a) = functional(a) for a < points, where cell c covers
// [first + c, first + c + 1] in units of the step.
Eigen::VectorXd exact_weights(double first, int points,
                              const std::function<double(int)>& functional) {
  Eigen::MatrixXd averages(points, points);
  Eigen::VectorXd wanted(points);
  for (int a = 0; a < points; ++a) {
    for (int c = 0; c < points; ++c) averages(a, c) = monomial_average(first + c, first + c + 1, a);
    wanted(a) = functional(a);
  }
  return averages.fullPivLu().solve(wanted);
}

LineOperator assemble(int rows, int columns, const Triplets& entries) {
  LineOperator matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Cells beyond the line hold p = 0.
void append(Triplets& entries, const UniformLine& line, int row, int first_cell,
            const Eigen::VectorXd& weights) {
  for (int c = 0; c < weights.size(); ++c) {
    const int cell = first_cell + c;
    if (weights(c) != 0 && cell >= 0 && cell < line.cells) {
      entries.emplace_back(row, cell, weights(c));
    }
  }
}

// Shifts a stencil off a boundary at face `limit` on its left.
int not_before(const UniformLine& line, int first, int limit) {
  return limit > 0 || line.left == Beyond::boundary ? std::max(first, limit) : first;
}

// A functional of the local coordinate xi = (x - x_face)/step on every inner face.
LineOperator on_inner_faces(const UniformLine& line, int points, Bias bias, double scale,
                            const std::function<double(int)>& functional) {
  Triplets entries;
  const int upstream = bias == Bias::left ? (points + 1) / 2 : points / 2;
  for (int f = 1; f < line.cells; ++f) {
    const int first = not_before(line, f - upstream, 0);
    append(entries, line, f, first, scale * exact_weights(first - f, points, functional));
  }
  return assemble(line.cells + 1, line.cells, entries);
}

double value_at_zero(int a) { return a == 0 ? 1.0 : 0.0; }
double slope_at_zero(int a) { return a == 1 ? 1.0 : 0.0; }

}  // namespace

LineOperator face_values(const UniformLine& line, int points, Bias bias) {
  return on_inner_faces(line, points, bias, 1.0, value_at_zero);
}

LineOperator face_derivatives(const UniformLine& line, int points) {
  return on_inner_faces(line, points, Bias::left, 1.0 / line.step, slope_at_zero);
}

LineOperator end_value(const UniformLine& line, int points) {
  Triplets entries;
  append(entries, line, 0, 0, exact_weights(0, points, value_at_zero));
  return assemble(1, line.cells, entries);
}

LineOperator weighted_averages(const UniformLine& line, int points, const Polynomial& weight,
                               std::optional<int> barrier) {
  Triplets entries;
  for (int i = 0; i < line.cells; ++i) {
    const bool beyond = barrier && i >= *barrier;
    int first = not_before(line, i - points / 2, beyond ? *barrier : 0);
    if (barrier && !beyond) first = std::min(first, *barrier - points);
    // weight(x_i + h xi) = sum_q local[q] xi^q, by repeated Horner division.
    Polynomial local = weight;
    const auto degree = local.size();
    for (std::size_t q = 0; q < degree; ++q) {
      for (std::size_t s = degree - 1; s-- > q;) local[s] += line.centre(i) * local[s + 1];
    }
    for (std::size_t q = 0; q < degree; ++q) local[q] *= std::pow(line.step, q);
    const auto functional = [&](int a) {
      double sum = 0;
      for (std::size_t q = 0; q < degree; ++q) {
        sum += local[q] * monomial_average(-0.5, 0.5, a + static_cast<int>(q));
      }
      return sum;
    };
    append(entries, line, i, first, exact_weights(first - i - 0.5, points, functional));
  }
  return assemble(line.cells, line.cells, entries);
}

LineOperator divergence(const UniformLine& line) {
  Triplets entries;
  for (int i = 0; i < line.cells; ++i) {
    entries.emplace_back(i, i, -1 / line.step);
    entries.emplace_back(i, i + 1, 1 / line.step);
  }
  return assemble(line.cells, line.cells + 1, entries);
}

int weighting_points(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
