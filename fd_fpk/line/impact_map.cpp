#include "fd_fpk/line/impact_map.hpp"

#include <cmath>
#include <vector>

#include "fd_fpk/line/cumulative.hpp"

namespace fpkcheck::fd_fpk {
namespace {

LineOperator exact_map(const Line& speeds, double restitution, int order) {
  const CumulativeInterpolation cumulative(speeds, order + 1, Beyond::boundary);
  const int cells = speeds.cells();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd below = Eigen::VectorXd::Zero(cells + 1);
  for (int a = 0; a < cells; ++a) {
    Eigen::VectorXd above = Eigen::VectorXd::Zero(cells + 1);
    // The last cell takes the flux of all higher speeds, so that the differences telescope.
    const double face = a + 1 == cells ? speeds.face(cells) : speeds.face(a + 1) / restitution;
    cumulative.add(face, 1.0, above);
    const Eigen::VectorXd row = cumulative.on_averages(above - below) / speeds.width(a);
    for (int b = 0; b < cells; ++b) {
      if (std::abs(row(b)) > 1e-15) entries.emplace_back(a, b, row(b));
    }
    below = above;
  }
  LineOperator matrix(cells, cells);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

LineOperator first_order_map(const Line& speeds, double restitution, int order) {
  const Line outgoing(speeds.faces(), Beyond::boundary);
  const LineOperator flux = face_values(outgoing, centred_points(order), Bias::left);
  LineOperator speed(speeds.cells() + 1, speeds.cells() + 1);
  for (int f = 0; f <= speeds.cells(); ++f) speed.insert(f, f) = (1 - restitution) * speeds.face(f);
  LineOperator matrix(speeds.cells(), speeds.cells());
  matrix.setIdentity();
  const LineOperator change = divergence(outgoing) * LineOperator(speed * flux);
  return matrix + change;
}

}  // namespace

LineOperator impact_map(const Line& speeds, double restitution, problem::Impact impact, int order) {
  return impact == problem::Impact::delta ? first_order_map(speeds, restitution, order)
                                          : exact_map(speeds, restitution, order);
}

}  // namespace fpkcheck::fd_fpk
