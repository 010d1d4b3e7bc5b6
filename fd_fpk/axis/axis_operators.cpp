#include "fd_fpk/axis/axis_operators.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

double monomial_average(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
}

// Returns the averages of the monomials xi^a, a < stencil_size, with xi = (x - origin)/scale, over
// the cells c from `first_cell`; row a, column c - first_cell.
Eigen::MatrixXd monomial_averages(const GridAxis& axis, int first_cell, int stencil_size,
                                  double origin, double scale) {
  Eigen::MatrixXd averages(stencil_size, stencil_size);
  for (int c = 0; c < stencil_size; ++c) {
    const double left = (axis.face_position(first_cell + c) - origin) / scale;
    const double right = (axis.face_position(first_cell + c + 1) - origin) / scale;
    for (int a = 0; a < stencil_size; ++a) averages(a, c) = monomial_average(left, right, a);
  }
  return averages;
}

// Returns stencil weights w_c such that sum_c w_c avg_c(xi^a) = functional(a), a < stencil_size,
// for the averages of xi^a over the cells c from `first_cell`, with xi = (x - origin)/scale.
Eigen::VectorXd exact_stencil_weights(const GridAxis& axis, int first_cell, int stencil_size,
                                      double origin, double scale,
                                      const std::function<double(int)>& functional) {
  Eigen::VectorXd exact(stencil_size);
  for (int a = 0; a < stencil_size; ++a) exact(a) = functional(a);
  return monomial_averages(axis, first_cell, stencil_size, origin, scale)
      .partialPivLu()
      .solve(exact);
}

AxisOperator sparse_matrix_from_entries(int rows, int columns, const Triplets& entries) {
  AxisOperator matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Appends the matrix entries of one finite-volume stencil. Cells outside the axis have density 0
// and no matrix entry.
void append_stencil(Triplets& entries, const GridAxis& axis, int row, int first_cell,
                    const Eigen::VectorXd& weights) {
  for (int c = 0; c < weights.size(); ++c) {
    const int cell = first_cell + c;
    if (weights(c) != 0 && cell >= 0 && cell < axis.cell_count()) {
      entries.emplace_back(row, cell, weights(c));
    }
  }
}

// Returns the first cell of a finite-volume stencil, moved left so that the stencil crosses no
// wall.
int clamp_at_right_boundary(const GridAxis& axis, int first, int stencil_size) {
  return axis.right_end_condition() != AxisEndCondition::vacuum
             ? std::min(first, axis.cell_count() - stencil_size)
             : first;
}

// Returns the first cell of a finite-volume stencil, moved right so that the stencil crosses no
// wall.
int clamp_at_left_boundary(const GridAxis& axis, int first, int limit) {
  return limit > 0 || axis.left_end_condition() == AxisEndCondition::boundary
             ? std::max(first, limit)
             : first;
}

// Returns the first cell of the finite-volume stencil of an inner face.
int first_face_stencil_cell(const GridAxis& axis, int face, int stencil_size,
                            UpstreamSideOfFace upstream_side) {
  const int upstream =
      upstream_side == UpstreamSideOfFace::left ? (stencil_size + 1) / 2 : stencil_size / 2;
  return clamp_at_right_boundary(axis, clamp_at_left_boundary(axis, face - upstream, 0),
                                 stencil_size);
}

// Returns the matrix that maps cell averages to a functional of the density at every inner face,
// such as the value of the density. The local coordinate at a cell face is xi = (x - x_face)/width,
// and the functional is divided by width^derivative.
AxisOperator inner_face_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side, int derivative,
                                 const std::function<double(int)>& functional) {
  Triplets entries;
  for (int f = 1; f < axis.cell_count(); ++f) {
    const int first = first_face_stencil_cell(axis, f, stencil_size, upstream_side);
    const double width = axis.cell_width(f);
    append_stencil(
        entries, axis, f, first,
        exact_stencil_weights(axis, first, stencil_size, axis.face_position(f), width, functional) /
            std::pow(width, derivative));
  }
  return sparse_matrix_from_entries(axis.cell_count() + 1, axis.cell_count(), entries);
}

// Basis functions of densities with a kink (DensityKink), with x in units of `length`.
class KinkedReconstructionBasis {
 public:
  KinkedReconstructionBasis(const DensityKink& kink, double length)
      : decay_(kink.decay * length), drift_(kink.drift * length) {}

  double basis_function_value(int index, double x) const {
    return std::exp(-decay_ * std::abs(x)) * polynomial_factor(index, x);
  }
  double basis_function_derivative(int index, double x) const {
    const double sign = x > 0 ? 1 : x < 0 ? -1 : 0;
    return std::exp(-decay_ * std::abs(x)) *
           (polynomial_factor_slope(index, x) - decay_ * sign * polynomial_factor(index, x));
  }

 private:
  double polynomial_factor(int index, double x) const {
    const double curved = decay_ * x * std::abs(x) / 2;
    return index == 0 ? 1 + drift_ * curved : index == 1 ? x + curved : std::pow(x, index);
  }
  double polynomial_factor_slope(int index, double x) const {
    const double curved = decay_ * std::abs(x);
    return index == 0 ? drift_ * curved : index == 1 ? 1 + curved : index * std::pow(x, index - 1);
  }

  double decay_, drift_;
};

// Replaces the stencils with cells on both sides of x = 0 by stencils that are exact for densities
// with a kink at x = 0. The argument `functional` returns the value or the derivative of a basis
// function that the stencil must reproduce.
template <class Functional>
AxisOperator with_kinked_stencils(const AxisOperator& smooth, const GridAxis& axis,
                                  int stencil_size, UpstreamSideOfFace upstream_side,
                                  const DensityKink& kink, int derivative,
                                  const Functional& functional) {
  using Gauss = boost::math::quadrature::gauss<double, 10>;
  Triplets entries;
  for (int f = 0; f <= axis.cell_count(); ++f) {
    const int first = f == 0 ? 0 : first_face_stencil_cell(axis, f, stencil_size, upstream_side);
    const bool has_kink =
        axis.face_position(first) < 0 && axis.face_position(first + stencil_size) > 0;
    if (f == 0 || f == axis.cell_count() || !has_kink) {
      for (AxisOperator::InnerIterator e(smooth, f); e; ++e) {
        entries.emplace_back(f, e.col(), e.value());
      }
      continue;
    }
    const double width = axis.cell_width(f);
    const KinkedReconstructionBasis basis(kink, width);
    Eigen::MatrixXd averages(stencil_size, stencil_size);
    Eigen::VectorXd exact(stencil_size);
    for (int c = 0; c < stencil_size; ++c) {
      const double left = axis.face_position(first + c) / width;
      const double right = axis.face_position(first + c + 1) / width;
      for (int a = 0; a < stencil_size; ++a) {
        averages(a, c) =
            Gauss::integrate([&](double x) { return basis.basis_function_value(a, x); }, left,
                             right) /
            (right - left);
      }
    }
    for (int a = 0; a < stencil_size; ++a) {
      exact(a) = functional(basis, a, axis.face_position(f) / width);
    }
    append_stencil(entries, axis, f, first,
                   averages.partialPivLu().solve(exact) / std::pow(width, derivative));
  }
  return sparse_matrix_from_entries(axis.cell_count() + 1, axis.cell_count(), entries);
}

int first_stencil_cell(const GridAxis& axis, int i, int stencil_size, std::optional<int> barrier) {
  const bool beyond = barrier && i >= *barrier;
  int first = clamp_at_left_boundary(axis, i - stencil_size / 2, beyond ? *barrier : 0);
  if (barrier && !beyond) first = std::min(first, *barrier - stencil_size);
  return clamp_at_right_boundary(axis, first, stencil_size);
}

double monomial_value_at_zero(int power) { return power == 0 ? 1.0 : 0.0; }
double monomial_slope_at_zero(int power) { return power == 1 ? 1.0 : 0.0; }

}  // namespace

AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side) {
  return inner_face_operator(axis, stencil_size, upstream_side, 0, monomial_value_at_zero);
}

AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size) {
  return inner_face_operator(axis, stencil_size, UpstreamSideOfFace::left, 1,
                             monomial_slope_at_zero);
}

AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side, const DensityKink& kink) {
  return with_kinked_stencils(face_value_operator(axis, stencil_size, upstream_side), axis,
                              stencil_size, upstream_side, kink, 0,
                              [](const KinkedReconstructionBasis& basis, int a, double x) {
                                return basis.basis_function_value(a, x);
                              });
}

AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size,
                                      const DensityKink& kink) {
  return with_kinked_stencils(face_derivative_operator(axis, stencil_size), axis, stencil_size,
                              UpstreamSideOfFace::left, kink, 1,
                              [](const KinkedReconstructionBasis& basis, int a, double x) {
                                return basis.basis_function_derivative(a, x);
                              });
}

AxisOperator end_value_operator(const GridAxis& axis, AxisEnd end, int stencil_size) {
  Triplets entries;
  const bool left = end == AxisEnd::left;
  const int last = axis.cell_count(), first_cell = left ? 0 : last - stencil_size;
  append_stencil(
      entries, axis, 0, first_cell,
      exact_stencil_weights(axis, first_cell, stencil_size, axis.face_position(left ? 0 : last),
                            axis.cell_width(left ? 0 : last - 1), monomial_value_at_zero));
  return sparse_matrix_from_entries(1, last, entries);
}

AxisOperator weighted_average_operator(const GridAxis& axis, int stencil_size,
                                       const numerics::Polynomial& weight,
                                       std::optional<int> barrier) {
  Triplets entries;
  const std::size_t degree = weight.degree();
  for (int i = 0; i < axis.cell_count(); ++i) {
    const int first = first_stencil_cell(axis, i, stencil_size, barrier);
    // Horner division expands the polynomial weight(x) about the cell centre x_i: weight(x_i + h_i
    // xi) = sum_q local[q] xi^q, with the cell width h_i.
    auto local = weight.coefficients();
    for (std::size_t q = 0; q <= degree; ++q) {
      for (std::size_t s = degree; s-- > q;) local[s] += axis.cell_centre(i) * local[s + 1];
    }
    for (std::size_t q = 0; q <= degree; ++q) local[q] *= std::pow(axis.cell_width(i), q);
    const auto functional = [&](int a) {
      double sum = 0;
      for (std::size_t q = 0; q <= degree; ++q) {
        sum += local[q] * monomial_average(-0.5, 0.5, a + static_cast<int>(q));
      }
      return sum;
    };
    append_stencil(entries, axis, i, first,
                   exact_stencil_weights(axis, first, stencil_size, axis.cell_centre(i),
                                         axis.cell_width(i), functional));
  }
  return sparse_matrix_from_entries(axis.cell_count(), axis.cell_count(), entries);
}

namespace {

// Returns the quadrature points of WeightedAverageMatrixBuilder in a cell with centre 0 and width
// 1.
const std::vector<numerics::QuadraturePoint>& quadrature_points() {
  static const auto points = numerics::composite_gauss_points<10>(-0.5, 0.5, 1);
  return points;
}

}  // namespace

WeightedAverageMatrixBuilder::WeightedAverageMatrixBuilder(const GridAxis& axis, int stencil_size,
                                                           std::optional<int> barrier)
    : axis_(axis) {
  const auto& points = quadrature_points();
  Eigen::MatrixXd monomials(stencil_size, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index k = 0; k < monomials.cols(); ++k) {
    const auto& [at, weight] = points[static_cast<std::size_t>(k)];
    for (int a = 0; a < stencil_size; ++a) monomials(a, k) = weight * std::pow(at, a);
  }
  for (int i = 0; i < axis.cell_count(); ++i) {
    const int first = first_stencil_cell(axis, i, stencil_size, barrier);
    stencils_.push_back({first, monomial_averages(axis, first, stencil_size, axis.cell_centre(i),
                                                  axis.cell_width(i))
                                    .partialPivLu()
                                    .solve(monomials)});
  }
}

AxisOperator WeightedAverageMatrixBuilder::weighted_average_matrix(
    const std::function<double(double)>& weight) const {
  const auto& points = quadrature_points();
  Triplets entries;
  Eigen::VectorXd values(static_cast<Eigen::Index>(points.size()));
  for (int i = 0; i < axis_.cell_count(); ++i) {
    const double centre = axis_.cell_centre(i), width = axis_.cell_width(i);
    std::ranges::transform(points, values.begin(), [&](const numerics::QuadraturePoint& point) {
      return weight(centre + width * point.at);
    });
    const auto& [first, stencil_weights_of_values] = stencils_[static_cast<std::size_t>(i)];
    append_stencil(entries, axis_, i, first, stencil_weights_of_values * values);
  }
  return sparse_matrix_from_entries(axis_.cell_count(), axis_.cell_count(), entries);
}

AxisOperator point_value_operator(const GridAxis& axis, int stencil_size,
                                  std::span<const double> fractions, std::optional<int> barrier) {
  Triplets entries;
  const int of_cell = static_cast<int>(fractions.size());
  for (int i = 0; i < axis.cell_count(); ++i) {
    const int first = first_stencil_cell(axis, i, stencil_size, barrier);
    for (int k = 0; k < of_cell; ++k) {
      const double xi = fractions[k] - 0.5;
      const auto value = [xi](int a) { return std::pow(xi, a); };
      append_stencil(entries, axis, i * of_cell + k, first,
                     exact_stencil_weights(axis, first, stencil_size, axis.cell_centre(i),
                                           axis.cell_width(i), value));
    }
  }
  return sparse_matrix_from_entries(of_cell * axis.cell_count(), axis.cell_count(), entries);
}

AxisOperator divergence_operator(const GridAxis& axis) {
  Triplets entries;
  for (int i = 0; i < axis.cell_count(); ++i) {
    entries.emplace_back(i, i, -1 / axis.cell_width(i));
    entries.emplace_back(i, i + 1, 1 / axis.cell_width(i));
  }
  return sparse_matrix_from_entries(axis.cell_count(), axis.cell_count() + 1, entries);
}

}  // namespace fpkcheck::fd_fpk
