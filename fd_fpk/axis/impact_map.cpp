#include "fd_fpk/axis/impact_map.hpp"

#include <cmath>
#include <vector>

#include "fd_fpk/axis/cumulative_interpolation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

AxisOperator exact_impact_map(const Axis& speeds, double restitution, int scheme_order) {
  const CumulativeInterpolation cumulative(speeds, scheme_order + 1, EndCondition::boundary);
  const int cells = speeds.cell_count();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd below = Eigen::VectorXd::Zero(cells + 1);
  for (int a = 0; a < cells; ++a) {
    Eigen::VectorXd above = Eigen::VectorXd::Zero(cells + 1);
    // The last cell receives the flux of all higher speeds, so that the sum of the differences is
    // the total flux.
    const double face =
        a + 1 == cells ? speeds.face_position(cells) : speeds.face_position(a + 1) / restitution;
    cumulative.add_weights_at(face, 1.0, above);
    const Eigen::VectorXd row = cumulative.to_average_weights(above - below) / speeds.cell_width(a);
    for (int b = 0; b < cells; ++b) {
      if (std::abs(row(b)) > 1e-15) entries.emplace_back(a, b, row(b));
    }
    below = above;
  }
  AxisOperator matrix(cells, cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

AxisOperator first_order_impact_map(const Axis& speeds, double restitution, int scheme_order) {
  const Axis outgoing(speeds.faces(), EndCondition::boundary);
  const AxisOperator flux =
      face_value_operator(outgoing, centred_stencil_size(scheme_order), UpstreamSide::left);
  AxisOperator speed(speeds.cell_count() + 1, speeds.cell_count() + 1);
  for (int f = 0; f <= speeds.cell_count(); ++f)
    speed.insert(f, f) = (1 - restitution) * speeds.face_position(f);
  AxisOperator matrix(speeds.cell_count(), speeds.cell_count());
  matrix.setIdentity();
  const AxisOperator change = divergence_operator(outgoing) * AxisOperator(speed * flux);
  return matrix + change;
}

}  // namespace

AxisOperator impact_map(const Axis& speeds, double restitution, problem::Impact impact,
                        int scheme_order) {
  return impact == problem::Impact::delta
             ? first_order_impact_map(speeds, restitution, scheme_order)
             : exact_impact_map(speeds, restitution, scheme_order);
}

}  // namespace fpkcheck::fd_fpk
