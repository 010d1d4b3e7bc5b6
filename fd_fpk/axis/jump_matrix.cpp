#include "fd_fpk/axis/jump_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fd_fpk/axis/impact_map.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr int kFaces = 8;  // number of faces in each stencil, for interpolation of degree 7

constexpr int kMoments = 8;  // degree of the polynomial through a face and neighbouring faces

std::vector<numerics::QuadraturePoint> gauss_points_on_short_panels(double a, double b,
                                                                    double max_panel_width) {
  return numerics::composite_gauss_points<8>(
      a, b, std::max(1, static_cast<int>(std::ceil((b - a) / max_panel_width))));
}

// C_0, C_1, .., C_cells are the values of the cumulative distribution C at the cell faces. Column f
// of the matrix `change` contains the weights of C_0 .. C_cells in E[C(x_f - Y)] - C_f, the mean
// change of the cumulative distribution at the face x_f by an impulse of amplitude Y.
Eigen::MatrixXd generator_matrix(const GridAxis& axis,
                                 const SpeedDistributionInterpolation& cumulative,
                                 const Eigen::MatrixXd& change) {
  const int cells = axis.cell_count();
  // Matrix entry (i, j) is the rate at which impulses move mass from velocity cell j, with density
  // 1, to velocity cell i.
  Eigen::MatrixXd masses(cells, cells);
  for (int i = 0; i < cells; ++i) {
    masses.row(i) =
        cumulative.cell_average_weights_from_face_weights(change.col(i + 1) - change.col(i))
            .transpose();
  }
  const Eigen::RowVectorXd lost = masses.colwise().sum();
  Eigen::MatrixXd generator = masses;
  generator.diagonal() -= lost.transpose();
  return axis.cell_widths().cwiseInverse().asDiagonal() * generator;
}

// Returns whether the four cells on each side of the face are wider than the length E[Y^8]^(1/8) of
// the impulse amplitude Y.
bool are_cells_wider_than_impulses(const GridAxis& axis, int face, double length) {
  for (int cell = face - kMoments / 2; cell < face + kMoments / 2; ++cell) {
    if (length >= axis.cell_width(cell)) return false;
  }
  return true;
}

// Adds the weights of the face values in E[C(face - Y)] - C(face), where the cumulative
// distribution C is approximated by the polynomial through the values at the face and the
// neighbouring faces.
void add_moment_expansion(const GridAxis& axis, int face, const problem::ImpulseLaw& law,
                          Eigen::Ref<Eigen::VectorXd> weights) {
  constexpr int kAround = kMoments / 2;
  const double unit = axis.cell_width(face);
  std::array<double, kMoments + 1> moments;  // moments of the scaled impulse -Y / unit
  for (int k = 0; k <= kMoments; ++k) moments[k] = law.moment(k) / std::pow(-unit, k);
  for (int a = -kAround; a <= kAround; ++a) {
    if (face + a <= 0) continue;  // the cumulative distribution C is 0 up to the first face
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

// Adds the weights of the contribution of amplitudes Y in [from, to] to E[C(face - Y)], for the
// cumulative distribution C and the continuous part of the law of Y.
void add_continuous_piece(const GridAxis& axis, const SpeedDistributionInterpolation& cumulative,
                          double face, const problem::ImpulseLaw& law, double from, double to,
                          Eigen::Ref<Eigen::VectorXd> weights) {
  const double longest = law.amplitude_standard_deviation();
  // The interpolating polynomial of the cumulative distribution C(u), with u = face - y, changes
  // where u is a cell face of the axis.
  const double left = std::max(face - to, axis.faces().front());
  const double right = std::min(face - from, axis.faces().back());
  const auto& faces = axis.faces();
  auto next = std::upper_bound(faces.begin(), faces.end(), left);
  for (double u = left; u < right; ++next) {
    const double end = std::min(*next, right);
    for (const auto& [at, weight] : gauss_points_on_short_panels(u, end, longest)) {
      cumulative.add_distribution_interpolation_weights(at, weight * law.density(face - at),
                                                        weights);
    }
    u = end;
  }
  const double farthest = face - faces.back();
  if (from < std::min(to, farthest)) {
    for (const auto& [y, weight] :
         gauss_points_on_short_panels(from, std::min(to, farthest), longest)) {
      weights(axis.cell_count()) += weight * law.density(y);
    }
  }
}

}  // namespace

Eigen::MatrixXd jump_matrix_of_fixed_amplitude(const GridAxis& axis, double amplitude) {
  const SpeedDistributionInterpolation cumulative(axis, kFaces, AxisEndCondition::vacuum);
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(axis.cell_count() + 1, axis.cell_count() + 1);
  for (int f = 0; f <= axis.cell_count(); ++f) {
    cumulative.add_distribution_interpolation_weights(axis.face_position(f) - amplitude, 1,
                                                      change.col(f));
    change(f, f) -= 1;
  }
  return generator_matrix(axis, cumulative, change);
}

Eigen::MatrixXd jump_matrix(const GridAxis& axis, const problem::ImpulseLaw& law) {
  const SpeedDistributionInterpolation cumulative(axis, kFaces, AxisEndCondition::vacuum);
  const auto pieces = law.amplitude_density_breakpoints();
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(axis.cell_count() + 1, axis.cell_count() + 1);
  const double length = std::pow(law.moment(kMoments), 1.0 / kMoments);
  for (int f = 0; f <= axis.cell_count(); ++f) {
    if (are_cells_wider_than_impulses(axis, f, length)) {
      add_moment_expansion(axis, f, law, change.col(f));
      continue;
    }
    for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
      add_continuous_piece(axis, cumulative, axis.face_position(f), law, pieces[piece],
                           pieces[piece + 1], change.col(f));
    }
    for (const auto& [amplitude, probability] : law.amplitude_atoms()) {
      cumulative.add_distribution_interpolation_weights(axis.face_position(f) - amplitude,
                                                        probability, change.col(f));
    }
    change(f, f) -= 1;
  }
  return generator_matrix(axis, cumulative, change);
}

namespace {

// Returns the upper end of a velocity cell. The upper end of the last velocity cell is infinite,
// since the last cell receives all mass above the axis.
double upper_end_of_cell(const GridAxis& axis, int cell) {
  return cell + 1 < axis.cell_count() ? axis.face_position(cell + 1)
                                      : std::numeric_limits<double>::infinity();
}

// Adds the velocity jumps by a law with a density, with four quadrature points in the source cell.
void add_density_jumps(const GridAxis& axis, const problem::ImpulseLaw& law, int from,
                       CellJumpMatrices& jumps) {
  for (const auto& [at, weight] : numerics::composite_gauss_points<4>(-0.5, 0.5, 1)) {
    const double offset = at * axis.cell_width(from);
    const double v = axis.cell_centre(from) + offset;
    double below = 0;
    for (int to = 0; to < axis.cell_count(); ++to) {
      const double end = upper_end_of_cell(axis, to);
      const double until = std::isinf(end) ? 1 : law.cumulative_probability(end - v);
      jumps.uniform(to, from) += weight * (until - below);
      jumps.slope(to, from) += weight * offset * (until - below);
      below = until;
    }
  }
}

// Adds the velocity jumps by one atom of the impulse law: the fraction of mass in each target cell
// is the overlap of the target cell with the shifted source cell.
void add_atom_jumps(const GridAxis& axis, const problem::AmplitudeAtom& atom, int from,
                    CellJumpMatrices& jumps) {
  const double left = axis.face_position(from) + atom.amplitude;
  const double right = axis.face_position(from + 1) + atom.amplitude;
  const double centre = axis.cell_centre(from) + atom.amplitude;
  for (int to = 0; to < axis.cell_count(); ++to) {
    const double begin =
        std::max(left, to == 0 ? -std::numeric_limits<double>::infinity() : axis.face_position(to));
    const double end = std::min(right, upper_end_of_cell(axis, to));
    if (!(end > begin)) continue;
    const double share = atom.probability * (end - begin) / (right - left);
    jumps.uniform(to, from) += share;
    jumps.slope(to, from) += share * ((begin + end) / 2 - centre);
  }
}

}  // namespace

CellJumpMatrices cell_jump_matrices(const GridAxis& axis, const problem::ImpulseLaw& law) {
  const int cells = axis.cell_count();
  CellJumpMatrices jumps{.uniform = Eigen::MatrixXd::Zero(cells, cells),
                         .slope = Eigen::MatrixXd::Zero(cells, cells)};
  const auto atoms = law.amplitude_atoms();
  for (int from = 0; from < cells; ++from) {
    if (atoms.empty()) add_density_jumps(axis, law, from, jumps);
    for (const auto& atom : atoms) add_atom_jumps(axis, atom, from, jumps);
  }
  return jumps;
}

}  // namespace fpkcheck::fd_fpk
