#include "fd_fpk/axis/impact_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fpkcheck::fd_fpk {

SpeedDistributionInterpolation::SpeedDistributionInterpolation(const GridAxis& axis, int face_count,
                                                               AxisEndCondition left_end)
    : axis_(axis), points_(std::min({face_count, axis.cell_count() + 1, kMaxInterpolationPoints})) {
  stencils_.reserve(axis.cell_count());
  for (int cell = 0; cell < axis.cell_count(); ++cell) {
    Stencil stencil{};
    stencil.first = cell - (points_ - 1) / 2;
    if (left_end == AxisEndCondition::boundary) {
      stencil.first = std::clamp(stencil.first, 0, axis.cell_count() + 1 - points_);
    }
    for (int a = 0; a < points_; ++a) stencil.faces[a] = axis.face_position(stencil.first + a);
    for (int a = 0; a < points_; ++a) {
      double denominator = 1;
      for (int b = 0; b < points_; ++b) {
        if (b != a) denominator *= stencil.faces[a] - stencil.faces[b];
      }
      stencil.inverse_denominators[a] = 1 / denominator;
    }
    stencils_.push_back(stencil);
  }
}

void SpeedDistributionInterpolation::add_distribution_interpolation_weights(
    double x, double factor, Eigen::Ref<Eigen::VectorXd> face_weights) const {
  const auto& faces = axis_.faces();
  const int last = axis_.cell_count();
  if (x <= faces.front()) return;
  if (x >= faces.back()) {
    face_weights(last) += factor;
    return;
  }
  const auto above = std::upper_bound(faces.begin(), faces.end(), x);
  const Stencil& stencil = stencils_[above - faces.begin() - 1];
  // The Lagrange weight prod_{b != a} (x - x_b) / (x_a - x_b) is the product over b < a times the
  // product over b > a.
  std::array<double, kMaxInterpolationPoints> before;
  double product = factor;
  for (int a = 0; a < points_; ++a) {
    before[a] = product;
    product *= x - stencil.faces[a];
  }
  double after = 1;
  for (int a = points_ - 1; a >= 0; --a) {
    const int face = stencil.first + a;
    if (face <= 0) break;  // C = 0 up to the first face
    face_weights(std::min(face, last)) += before[a] * after * stencil.inverse_denominators[a];
    after *= x - stencil.faces[a];
  }
}

Eigen::VectorXd SpeedDistributionInterpolation::cell_average_weights_from_face_weights(
    const Eigen::Ref<const Eigen::VectorXd>& face_weights) const {
  Eigen::VectorXd weights(axis_.cell_count());
  double sum = 0;
  for (int i = axis_.cell_count() - 1; i >= 0; --i) {
    sum += face_weights(i + 1);
    weights(i) = sum * axis_.cell_width(i);
  }
  return weights;
}

namespace {

AxisOperator exact_impact_map(const GridAxis& speed_axis, const problem::Wall& wall,
                              int scheme_order) {
  const SpeedDistributionInterpolation cumulative(speed_axis, scheme_order + 1,
                                                  AxisEndCondition::boundary);
  const int cells = speed_axis.cell_count();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd below = Eigen::VectorXd::Zero(cells + 1);
  for (int a = 0; a < cells; ++a) {
    Eigen::VectorXd above = Eigen::VectorXd::Zero(cells + 1);
    // The last speed cell receives the flux of all higher speeds, so that the total flux is
    // conserved.
    const double face = a + 1 == cells
                            ? speed_axis.face_position(cells)
                            : problem::speed_before_impact(wall, speed_axis.face_position(a + 1));
    cumulative.add_distribution_interpolation_weights(face, 1.0, above);
    const Eigen::VectorXd row =
        cumulative.cell_average_weights_from_face_weights(above - below) / speed_axis.cell_width(a);
    for (int b = 0; b < cells; ++b) {
      if (std::abs(row(b)) > 1e-15) entries.emplace_back(a, b, row(b));
    }
    below = above;
  }
  AxisOperator matrix(cells, cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

AxisOperator first_order_impact_map(const GridAxis& speed_axis, const problem::Wall& wall,
                                    int scheme_order) {
  const GridAxis outgoing(speed_axis.faces(), AxisEndCondition::boundary);
  const AxisOperator flux =
      face_value_operator(outgoing, centred_stencil_size(scheme_order), UpstreamSideOfFace::left);
  AxisOperator speed(speed_axis.cell_count() + 1, speed_axis.cell_count() + 1);
  for (int f = 0; f <= speed_axis.cell_count(); ++f) {
    const double u = speed_axis.face_position(f);
    speed.insert(f, f) = (1 - wall.restitution_at_speed(u)) * u;
  }
  AxisOperator matrix(speed_axis.cell_count(), speed_axis.cell_count());
  matrix.setIdentity();
  const AxisOperator change = divergence_operator(outgoing) * AxisOperator(speed * flux);
  return matrix + change;
}

}  // namespace

AxisOperator impact_map(const GridAxis& speed_axis, const problem::Wall& wall,
                        problem::ImpactCondition impact, int scheme_order) {
  return impact == problem::ImpactCondition::delta
             ? first_order_impact_map(speed_axis, wall, scheme_order)
             : exact_impact_map(speed_axis, wall, scheme_order);
}

}  // namespace fpkcheck::fd_fpk
