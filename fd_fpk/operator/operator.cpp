#include "fd_fpk/operator/operator.hpp"

#include <cmath>

#include "fd_fpk/axis/impact_map.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// The Kronecker product A (x) B: A acts on x1, B on x2; cell (i, j) has index i nv + j.
SparseColumns kronecker_product(const AxisOperator& a, const AxisOperator& b) {
  const SparseColumns a_columns(a), b_columns(b);
  SparseColumns product(a.rows() * b.rows(), a.cols() * b.cols());
  product.reserve(a.nonZeros() * b.nonZeros());
  for (Eigen::Index column = 0; column < product.cols(); ++column) {
    product.startVec(column);
    for (SparseColumns::InnerIterator x1(a_columns, column / b.cols()); x1; ++x1) {
      for (SparseColumns::InnerIterator x2(b_columns, column % b.cols()); x2; ++x2) {
        product.insertBack(x1.row() * b.rows() + x2.row(), column) = x1.value() * x2.value();
      }
    }
  }
  product.finalize();
  return product;
}

AxisOperator identity(int n) {
  AxisOperator matrix(n, n);
  matrix.setIdentity();
  return matrix;
}

// The matrix whose only nonzero entry is `value` at (row, column).
AxisOperator entry(int rows, int columns, int row, int column, double value) {
  AxisOperator matrix(rows, columns);
  matrix.insert(row, column) = value;
  return matrix;
}

// The matrix with the rows first .. first+count-1 of `matrix` and zeros in all other rows.
AxisOperator keep_rows(const AxisOperator& matrix, int first, int count) {
  AxisOperator mask(matrix.rows(), matrix.rows());
  for (int r = first; r < first + count; ++r) mask.insert(r, r) = 1.0;
  return mask * matrix;
}

// The matrix of the streaming term -d/dx1 (x2 p), by fluxes through the inner faces of x1.
SparseColumns streaming(const Grid& grid, int order, int weight_points) {
  const Axis& x1 = grid.x1;
  const AxisOperator minus_speed =
      weighted_averages(grid.x2, weight_points, numerics::Polynomial({0, -1}));
  const int half = grid.nv() / 2;
  const AxisOperator rightwards = divergence(x1) * face_values(x1, order, Bias::left);
  const AxisOperator leftwards = divergence(x1) * face_values(x1, order, Bias::right);
  return kronecker_product(rightwards, keep_rows(minus_speed, half, half)) +
         kronecker_product(leftwards, keep_rows(minus_speed, 0, half));
}

// The index of the velocity cell for cell b of the speed axis: for motion into the wall at the
// given end, and for motion away from this wall.
int outgoing_cell(const Grid& grid, End end, int b) {
  const int half = grid.nv() / 2;
  return end == End::left ? half - 1 - b : half + b;
}
int returning_cell(const Grid& grid, End end, int b) {
  return outgoing_cell(grid, end == End::left ? End::right : End::left, b);
}

// The matrix of the impacts at a wall. The probability flux into the wall leaves the column of
// cells at the wall (x2 < 0 at the left end) and enters the same column again with the other sign
// of x2.
SparseColumns exchange_at_wall(double restitution, problem::Impact impact, const Grid& grid,
                               int order, End end) {
  const int half = grid.nv() / 2;
  AxisOperator exchange(grid.nv(), half);  // maps fluxes in speed cells to rates in velocity cells
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int b = 0; b < half; ++b) entries.emplace_back(outgoing_cell(grid, end, b), b, -1.0);
    const AxisOperator returned = impact_map(grid.speeds(), restitution, impact, order);
    for (int a = 0; a < half; ++a) {
      for (AxisOperator::InnerIterator e(returned, a); e; ++e) {
        entries.emplace_back(returning_cell(grid, end, a), e.col(), e.value());
      }
    }
    exchange.setFromTriplets(entries.begin(), entries.end());
  }
  const int column = end == End::left ? 0 : grid.nx() - 1;
  const AxisOperator into_column = entry(grid.nx(), 1, column, 0, 1 / grid.x1.width(column));
  return kronecker_product(into_column, exchange) * wall_flux(grid, order, end);
}

// The matrix of the term d/dx2 [ x2^power p ], by fluxes through the inner faces of x2. `values`
// maps cell averages to values of p on the faces.
AxisOperator divergence_of_power(const Axis& x2, int power, const AxisOperator& values) {
  AxisOperator factor(x2.cells() + 1, x2.cells() + 1);
  for (int f = 0; f <= x2.cells(); ++f) factor.insert(f, f) = std::pow(x2.face(f), power);
  return divergence(x2) * AxisOperator(factor * values);
}

// The matrix of the term d/dx2 [ (c x2 + g(x1)) p ], by fluxes through the inner faces of x2.
SparseColumns damping_and_restoring_force(const problem::System& system, const Grid& grid,
                                          int order, int weight_points) {
  const Axis& x2 = grid.x2;
  const AxisOperator values = face_values(x2, centred_points(order), Bias::left);
  if (!system.damping_is_constant()) {
    const AxisOperator force = weighted_averages(grid.x1, weight_points, system.force());
    const AxisOperator damping =
        weighted_averages(grid.x1, weight_points, system.damping_polynomial());
    SparseColumns sum = kronecker_product(damping, divergence_of_power(x2, 1, values)) +
                        kronecker_product(force, divergence(x2) * values);
    if (system.rayleigh() != 0) {
      sum += kronecker_product(identity(grid.nx()),
                               system.rayleigh() * divergence_of_power(x2, 3, values));
    }
    return sum;
  }
  AxisOperator velocity(grid.nv() + 1, grid.nv() + 1);
  for (int f = 0; f <= grid.nv(); ++f) velocity.insert(f, f) = system.damping() * x2.face(f);
  const AxisOperator force = weighted_averages(grid.x1, weight_points, system.force());
  const AxisOperator damping = divergence(x2) * AxisOperator(velocity * values);
  return kronecker_product(identity(grid.nx()), damping) +
         kronecker_product(force, divergence(x2) * values);
}

// The matrix of the difference between the upwind-biased and the centred transport terms in x2, for
// an odd order. With the velocity a = -(c x2 + g(x1) + ..) the upwind flux is
//     a (p_left + p_right)/2 + |a| (p_left - p_right)/2,
// and its first term is the centred flux of the next even order.
SparseColumns upwind_correction(const problem::System& system, const Grid& grid, int order) {
  const Axis& x1 = grid.x1;
  const Axis& x2 = grid.x2;
  const AxisOperator columns = identity(grid.nx());
  const AxisOperator jump =
      face_values(x2, order, Bias::left) - face_values(x2, order, Bias::right);
  SparseColumns flux = kronecker_product(columns, jump);
  const int faces = grid.nv() + 1;
  const bool constant = system.damping_is_constant();
  for (Eigen::Index column = 0; column < flux.cols(); ++column) {
    for (SparseColumns::InnerIterator e(flux, column); e; ++e) {
      const double x1_at = x1.centre(static_cast<int>(e.row()) / faces);
      const double x2_at = x2.face(static_cast<int>(e.row()) % faces);
      const double linear =
          constant
              ? system.damping() * x2_at
              : (system.damping_polynomial()(x1_at) + system.rayleigh() * x2_at * x2_at) * x2_at;
      e.valueRef() *= -0.5 * std::abs(linear + system.force()(x1_at));
    }
  }
  return kronecker_product(columns, divergence(x2)) * flux;
}

}  // namespace

SparseColumns scale_and_shift(double factor, const SparseColumns& a, double shift) {
  SparseColumns unit(a.rows(), a.cols());
  unit.setIdentity();
  return factor * a + shift * unit;
}

SparseColumns wall_flux(const Grid& grid, int order, End end) {
  const int half = grid.nv() / 2;
  const bool left = end == End::left;
  // The density on the wall jumps at x2 = 0, so a stencil contains only cells with one sign of x2.
  const AxisOperator speed = weighted_averages(grid.x2, weighting_points(order),
                                               numerics::Polynomial({0, left ? -1.0 : 1.0}), half);
  AxisOperator in_order(half, grid.nv());
  for (int b = 0; b < half; ++b) in_order.insert(b, outgoing_cell(grid, end, b)) = 1.0;
  return kronecker_product(
      left ? first_face_value(grid.x1, order) : last_face_value(grid.x1, order),
      AxisOperator(in_order * speed));
}

FokkerPlanckOperator fokker_planck_operator(const problem::System& system,
                                            const Excitation& excitation, problem::Impact impact,
                                            const Grid& grid, int order, Weighting weighting) {
  const int weight_points = weighting == Weighting::full ? weighting_points(order) : 1;
  SparseColumns local = streaming(grid, order, weight_points);
  if (system.left()) {
    local += exchange_at_wall(system.left()->restitution, impact, grid, order, End::left);
  }
  if (system.right()) {
    local += exchange_at_wall(system.right()->restitution, impact, grid, order, End::right);
  }
  local += damping_and_restoring_force(system, grid, order, weight_points);
  local += kronecker_product(identity(grid.nx()),
                             local_excitation(grid.x2, excitation, centred_points(order)));
  if (order % 2 == 1) local += upwind_correction(system, grid, order);
  local.prune(0.0);
  local.makeCompressed();
  return {std::move(local), excitation.exchange, grid.areas()};
}

Eigen::VectorXd FokkerPlanckOperator::operator*(const Eigen::VectorXd& averages) const {
  Eigen::VectorXd rate = local * averages;
  if (exchange.size() > 0) {
    const Eigen::Index nv = exchange.rows(), nx = averages.size() / nv;
    Eigen::Map<Eigen::MatrixXd>(rate.data(), nv, nx).noalias() +=
        exchange * Eigen::Map<const Eigen::MatrixXd>(averages.data(), nv, nx);
  }
  return rate;
}

SparseColumns FokkerPlanckOperator::assembled() const {
  if (exchange.size() == 0) return local;
  // Jumps by a whole number of cells cause rounding errors in entries whose exact value is zero.
  constexpr double kRounding = 1e-14;
  const int nx = static_cast<int>(areas.size() / exchange.rows());
  return local + kronecker_product(identity(nx),
                                   exchange.sparseView(exchange.cwiseAbs().maxCoeff(), kRounding));
}

double FokkerPlanckOperator::leak() const {
  Eigen::RowVectorXd rate = areas.transpose() * local;
  if (exchange.size() > 0) {
    const Eigen::Index nv = exchange.rows(), nx = areas.size() / nv;
    Eigen::Map<Eigen::MatrixXd>(rate.data(), nv, nx).noalias() +=
        exchange.transpose() * Eigen::Map<const Eigen::MatrixXd>(areas.data(), nv, nx);
  }
  return rate.transpose().cwiseQuotient(areas).cwiseAbs().maxCoeff();
}

double FokkerPlanckOperator::residual(const Eigen::VectorXd& averages) const {
  return areas.dot((*this * averages).cwiseAbs()) / areas.dot(averages.cwiseAbs());
}

}  // namespace fpkcheck::fd_fpk
