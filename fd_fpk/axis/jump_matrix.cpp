#include "fd_fpk/axis/jump_matrix.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

#include "fd_fpk/axis/cumulative_interpolation.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr int kFaces = 8;  // number of faces in an interpolation stencil, for degree 7

constexpr int kMoments = 8;  // degree of the polynomial through a face and its neighbours

// Calls visit(y, weight) for a composite rule on [a, b] with panels not longer than `longest`.
template <class Visitor>
void for_each_gauss_legendre_node(double a, double b, double longest, const Visitor& visit) {
  using Rule = boost::math::quadrature::gauss<double, 8>;
  const int panels = std::max(1, static_cast<int>(std::ceil((b - a) / longest)));
  const double half = (b - a) / (2 * panels);
  for (int k = 0; k < panels; ++k) {
    const double middle = a + (2 * k + 1) * half;
    for (std::size_t n = 0; n < Rule::abscissa().size(); ++n) {
      visit(middle - half * Rule::abscissa()[n], half * Rule::weights()[n]);
      visit(middle + half * Rule::abscissa()[n], half * Rule::weights()[n]);
    }
  }
}

// The generator matrix, from the change of the cumulative distribution C. Column f of `change`
// contains the weights of C_0 .. C_cells in the change of C at face f.
Eigen::MatrixXd generator_matrix(const Axis& axis, const CumulativeInterpolation& cumulative,
                                 const Eigen::MatrixXd& change) {
  const int cells = axis.cell_count();
  // rate at which mass moves from cell j (average 1) to cell i
  Eigen::MatrixXd masses(cells, cells);
  for (int i = 0; i < cells; ++i) {
    masses.row(i) = cumulative.to_average_weights(change.col(i + 1) - change.col(i)).transpose();
  }
  const Eigen::RowVectorXd lost = masses.colwise().sum();
  Eigen::MatrixXd generator = masses;
  generator.diagonal() -= lost.transpose();
  return axis.cell_widths().cwiseInverse().asDiagonal() * generator;
}

// Whether E[Y^8]^(1/8) is below the width of each of the two cells at the face.
bool are_impulses_within_neighbours(const Axis& axis, int face, double length) {
  for (int cell = face - kMoments / 2; cell < face + kMoments / 2; ++cell) {
    if (length >= axis.cell_width(cell)) return false;
  }
  return true;
}

// Adds the weights of E[C(face - Y)] - C(face), with C approximated by the polynomial through this
// face and its neighbours. The result is the sum of (-1)^k E[Y^k]/k! times the derivatives at the
// face, k = 1 .. kMoments.
void add_moment_expansion(const Axis& axis, int face, const problem::ImpulseLaw& law,
                          Eigen::Ref<Eigen::VectorXd> weights) {
  constexpr int kAround = kMoments / 2;
  const double unit = axis.cell_width(face);
  std::array<double, kMoments + 1> moments;  // moments of -Y / unit
  for (int k = 0; k <= kMoments; ++k) moments[k] = law.moment(k) / std::pow(-unit, k);
  for (int a = -kAround; a <= kAround; ++a) {
    if (face + a <= 0) continue;  // C is 0 at the first face and left of the axis
    // Coefficients of the Lagrange polynomial prod_{b != a} (z - z_b) / (z_a - z_b).
    const auto at = [&](int b) {
      return (axis.face_position(face + b) - axis.face_position(face)) / unit;
    };
    std::array<double, kMoments + 1> coefficients{1};
    int degree = 0;
    for (int b = -kAround; b <= kAround; ++b) {
      if (b == a) continue;
      const double scale = 1 / (at(a) - at(b));
      for (int k = ++degree; k > 0; --k) {
        coefficients[k] = scale * (coefficients[k - 1] - at(b) * coefficients[k]);
      }
      coefficients[0] *= -scale * at(b);
    }
    double weight = 0;
    for (int k = 1; k <= kMoments; ++k) weight += coefficients[k] * moments[k];
    weights(std::min(face + a, axis.cell_count())) += weight;
  }
}

// Adds the weights of E[C(face - Y); Y in [from, to]] for the continuous part of a law, with
// density f.
void add_continuous_piece(const Axis& axis, const CumulativeInterpolation& cumulative, double face,
                          const problem::ImpulseLaw& law, double from, double to,
                          Eigen::Ref<Eigen::VectorXd> weights) {
  const double longest = law.deviation();
  // As a function of u = face - y, the interpolating polynomial changes at the faces of the axis.
  const double left = std::max(face - to, axis.faces().front());
  const double right = std::min(face - from, axis.faces().back());
  const auto visit = [&](double u, double weight) {
    cumulative.add_weights_at(u, weight * law.density(face - u), weights);
  };
  const auto& faces = axis.faces();
  auto next = std::upper_bound(faces.begin(), faces.end(), left);
  for (double u = left; u < right; ++next) {
    const double end = std::min(*next, right);
    for_each_gauss_legendre_node(u, end, longest, visit);
    u = end;
  }
  // Right of the axis the cumulative distribution is constant.
  const double farthest = face - faces.back();
  if (from < std::min(to, farthest)) {
    for_each_gauss_legendre_node(
        from, std::min(to, farthest), longest,
        [&](double y, double weight) { weights(axis.cell_count()) += weight * law.density(y); });
  }
}

}  // namespace

Eigen::MatrixXd shift_matrix(const Axis& axis, double amplitude) {
  const CumulativeInterpolation cumulative(axis, kFaces, EndCondition::vacuum);
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(axis.cell_count() + 1, axis.cell_count() + 1);
  for (int f = 0; f <= axis.cell_count(); ++f) {
    cumulative.add_weights_at(axis.face_position(f) - amplitude, 1, change.col(f));
    change(f, f) -= 1;
  }
  return generator_matrix(axis, cumulative, change);
}

Eigen::MatrixXd jump_matrix(const Axis& axis, const problem::ImpulseLaw& law) {
  const CumulativeInterpolation cumulative(axis, kFaces, EndCondition::vacuum);
  const auto pieces = law.density_breakpoints();
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(axis.cell_count() + 1, axis.cell_count() + 1);
  const double length = std::pow(law.moment(kMoments), 1.0 / kMoments);
  for (int f = 0; f <= axis.cell_count(); ++f) {
    if (are_impulses_within_neighbours(axis, f, length)) {
      add_moment_expansion(axis, f, law, change.col(f));
      continue;
    }
    for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
      add_continuous_piece(axis, cumulative, axis.face_position(f), law, pieces[piece],
                           pieces[piece + 1], change.col(f));
    }
    for (const auto& [amplitude, probability] : law.atoms()) {
      cumulative.add_weights_at(axis.face_position(f) - amplitude, probability, change.col(f));
    }
    change(f, f) -= 1;
  }
  return generator_matrix(axis, cumulative, change);
}

}  // namespace fpkcheck::fd_fpk
