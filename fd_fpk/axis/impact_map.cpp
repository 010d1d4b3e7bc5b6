#include "fd_fpk/axis/impact_map.hpp"

#include <cmath>
#include <vector>

#include "fd_fpk/axis/cumulative_interpolation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

AxisOperator exact_map(const Axis& speeds, double restitution, int order) {
  const CumulativeInterpolation cumulative(speeds, order + 1, EndCondition::boundary);
  const int cells = speeds.cells();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd below = Eigen::VectorXd::Zero(cells + 1);
  for (int a = 0; a < cells; ++a) {
    Eigen::VectorXd above = Eigen::VectorXd::Zero(cells + 1);
    // The last cell receives the flux of all higher speeds, so that the sum of the differences is
    // the total flux.
    const double face = a + 1 == cells ? speeds.face(cells) : speeds.face(a + 1) / restitution;
    cumulative.add(face, 1.0, above);
    const Eigen::VectorXd row = cumulative.to_average_weights(above - below) / speeds.width(a);
    for (int b = 0; b < cells; ++b) {
      if (std::abs(row(b)) > 1e-15) entries.emplace_back(a, b, row(b));
    }
    below = above;
  }
  AxisOperator matrix(cells, cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

AxisOperator first_order_map(const Axis& speeds, double restitution, int order) {
  const Axis outgoing(speeds.faces(), EndCondition::boundary);
  const AxisOperator flux = face_values(outgoing, centred_points(order), Bias::left);
  AxisOperator speed(speeds.cells() + 1, speeds.cells() + 1);
  for (int f = 0; f <= speeds.cells(); ++f) speed.insert(f, f) = (1 - restitution) * speeds.face(f);
  AxisOperator matrix(speeds.cells(), speeds.cells());
  matrix.setIdentity();
  const AxisOperator change = divergence(outgoing) * AxisOperator(speed * flux);
  return matrix + change;
}

}  // namespace

AxisOperator impact_map(const Axis& speeds, double restitution, problem::Impact impact, int order) {
  return impact == problem::Impact::delta ? first_order_map(speeds, restitution, order)
                                          : exact_map(speeds, restitution, order);
}

}  // namespace fpkcheck::fd_fpk
