#include "fd_fpk/operator/parametric_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "fd_fpk/axis/jump_matrix.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Interpolation at a factor b of the impulse amplitude uses the values b_m = m d with the spacing
// d, for the integers m from floor(b/d) - kBelow to floor(b/d) + kAbove.
constexpr int kBelow = 2, kAbove = 3;

// Returns the Lagrange polynomial at t of the integer `node` among the six integers around t.
double lagrange_polynomial(double t, int node) {
  const int base = static_cast<int>(std::floor(t));
  if (node < base - kBelow || node > base + kAbove) return 0;
  double value = 1;
  for (int other = base - kBelow; other <= base + kAbove; ++other) {
    if (other != node) value *= (t - other) / (node - other);
  }
  return value;
}

// Returns the matrix of the velocity jumps by b Y, which equal jumps by the impulse amplitude Y on
// the axis divided by b.
Eigen::MatrixXd scaled_jump_matrix(const GridAxis& axis, const problem::ImpulseLaw& law, double b) {
  std::vector<double> faces = axis.faces();
  for (double& face : faces) face /= std::abs(b);
  return jump_matrix(GridAxis(std::move(faces)), b < 0 ? law.with_negated_amplitudes() : law);
}

// Returns the smallest and the largest sampled value of the factor of the impulses on an axis.
std::pair<double, double> range_of_factor(const problem::StateFunction& factor,
                                          const GridAxis& x1) {
  constexpr int kPoints = 8;
  double least = factor(x1.faces().front(), 0), largest = least;
  for (int i = 0; i < x1.cell_count(); ++i) {
    for (int k = 1; k <= kPoints; ++k) {
      const double b = factor(x1.face_position(i) + x1.cell_width(i) * k / kPoints, 0);
      least = std::min(least, b);
      largest = std::max(largest, b);
    }
  }
  return {least, largest};
}

}  // namespace

std::vector<NonlocalExcitationTerm> parametric_exchange_terms(const ParametricImpulses& impulses,
                                                              const PhasePlaneGrid& grid,
                                                              int weight_stencil_size) {
  const problem::ImpulseLaw& law = impulses.train.amplitude_law();
  const double distance = grid.x2.cell_widths().maxCoeff() / std::sqrt(law.moment(2));
  const auto [least, largest] = range_of_factor(impulses.factor, grid.x1);
  // The range of interpolation values has one additional value on either side, because
  // range_of_factor() samples the factor and may miss the extreme values of the factor.
  int first = static_cast<int>(std::floor(least / distance)) - kBelow - 1;
  int last = static_cast<int>(std::floor(largest / distance)) + kAbove + 1;
  // If the law of the amplitude Y is symmetric, the jumps by b Y and by -b Y have equal matrices.
  const bool is_symmetric = law.is_symmetric();
  if (is_symmetric) {
    last = std::max(last, -first);
    first = 1;
  }
  const WeightedAverageMatrixBuilder averages(grid.x1, weight_stencil_size);
  std::vector<NonlocalExcitationTerm> terms;
  for (int node = first; node <= last; ++node) {
    if (node == 0) continue;  // impulses that the factor 0 multiplies change nothing
    AxisOperator of_x1 = averages.weighted_average_matrix([&](double x1) {
      const double t = impulses.factor(x1, 0) / distance;
      return lagrange_polynomial(t, node) + (is_symmetric ? lagrange_polynomial(t, -node) : 0);
    });
    if (of_x1.nonZeros() == 0) continue;
    terms.push_back({std::move(of_x1), impulses.train.arrival_rate() *
                                           scaled_jump_matrix(grid.x2, law, node * distance)});
  }
  return terms;
}

}  // namespace fpkcheck::fd_fpk
