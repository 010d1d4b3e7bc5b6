#include "fd_fpk/operator/fokker_planck_operator.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "fd_fpk/axis/impact_map.hpp"
#include "fd_fpk/operator/parametric_exchange.hpp"
#include "problem/system.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Returns the Kronecker product A (x) B of a matrix A for the displacement x1 and a matrix B for
// the velocity x2; cell (i, j) has the index i nv + j.
SparseColumnMatrix kronecker_product(const AxisOperator& a, const AxisOperator& b) {
  const SparseColumnMatrix a_columns(a), b_columns(b);
  SparseColumnMatrix product(a.rows() * b.rows(), a.cols() * b.cols());
  product.reserve(a.nonZeros() * b.nonZeros());
  for (Eigen::Index column = 0; column < product.cols(); ++column) {
    product.startVec(column);
    for (SparseColumnMatrix::InnerIterator x1(a_columns, column / b.cols()); x1; ++x1) {
      for (SparseColumnMatrix::InnerIterator x2(b_columns, column % b.cols()); x2; ++x2) {
        product.insertBack(x1.row() * b.rows() + x2.row(), column) = x1.value() * x2.value();
      }
    }
  }
  product.finalize();
  return product;
}

AxisOperator identity_matrix(int n) {
  AxisOperator matrix(n, n);
  matrix.setIdentity();
  return matrix;
}

AxisOperator single_entry_matrix(int rows, int columns, int row, int column, double value) {
  AxisOperator matrix(rows, columns);
  matrix.insert(row, column) = value;
  return matrix;
}

AxisOperator keep_rows(const AxisOperator& matrix, int first_row, int row_count) {
  AxisOperator mask(matrix.rows(), matrix.rows());
  for (int r = first_row; r < first_row + row_count; ++r) mask.insert(r, r) = 1.0;
  return mask * matrix;
}

// Returns the matrix of the streaming term -d/dx1 (x2 p), by fluxes through the inner cell faces of
// x1. No stencil for the cell averages of x2 p contains cells on both sides of a kink of the
// density p at x2 = 0.
SparseColumnMatrix streaming_matrix(const PhasePlaneGrid& grid, int scheme_order,
                                    int weight_stencil_size, bool has_kinks) {
  const GridAxis& x1 = grid.x1;
  const int half = grid.v_cell_count() / 2;
  const AxisOperator minus_speed =
      weighted_average_operator(grid.x2, weight_stencil_size, numerics::Polynomial({0, -1}),
                                has_kinks ? std::optional(half) : std::nullopt);
  const AxisOperator rightwards =
      divergence_operator(x1) * face_value_operator(x1, scheme_order, UpstreamSideOfFace::left);
  // At a barrier the density of leftward motion is 0, since no motion enters through the barrier.
  const bool has_barrier = x1.right_end_condition() == AxisEndCondition::barrier;
  const AxisOperator leftwards =
      divergence_operator(x1) *
      face_value_operator(has_barrier ? x1.with_right_end_condition(AxisEndCondition::vacuum) : x1,
                          scheme_order, UpstreamSideOfFace::right);
  return kronecker_product(rightwards, keep_rows(minus_speed, half, half)) +
         kronecker_product(leftwards, keep_rows(minus_speed, 0, half));
}

// Returns the index of the velocity cell of motion into the wall, for cell b of the speed axis.
int cell_of_motion_into_wall(const PhasePlaneGrid& grid, AxisEnd end, int speed_cell) {
  const int half = grid.v_cell_count() / 2;
  return end == AxisEnd::left ? half - 1 - speed_cell : half + speed_cell;
}
int cell_of_motion_off_wall(const PhasePlaneGrid& grid, AxisEnd end, int speed_cell) {
  return cell_of_motion_into_wall(grid, end == AxisEnd::left ? AxisEnd::right : AxisEnd::left,
                                  speed_cell);
}

// Returns the matrix of the impacts at a wall. The probability flux into the wall leaves the cells
// at the wall and enters the cells with the opposite sign of the velocity x2.
SparseColumnMatrix wall_exchange_matrix(const problem::Wall& wall, problem::ImpactCondition impact,
                                        const PhasePlaneGrid& grid, int scheme_order, AxisEnd end) {
  const int half = grid.v_cell_count() / 2;
  // Matrix that maps probability fluxes in speed cells to rates of change in velocity cells
  AxisOperator exchange(grid.v_cell_count(), half);
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int b = 0; b < half; ++b)
      entries.emplace_back(cell_of_motion_into_wall(grid, end, b), b, -1.0);
    const AxisOperator returned = impact_map(grid.speed_axis(), wall, impact, scheme_order);
    for (int a = 0; a < half; ++a) {
      for (AxisOperator::InnerIterator e(returned, a); e; ++e) {
        entries.emplace_back(cell_of_motion_off_wall(grid, end, a), e.col(), e.value());
      }
    }
    exchange.setFromTriplets(entries.begin(), entries.end());
  }
  const int column = end == AxisEnd::left ? 0 : grid.nx() - 1;
  const AxisOperator into_column =
      single_entry_matrix(grid.nx(), 1, column, 0, 1 / grid.x1.cell_width(column));
  return kronecker_product(into_column, exchange) * wall_flux_matrix(grid, scheme_order, end);
}

// Returns the matrix of the probability flux that leaves through a barrier at the right end of x1.
SparseColumnMatrix barrier_outflow_matrix(const PhasePlaneGrid& grid, int scheme_order) {
  const int half = grid.v_cell_count() / 2, last = grid.nx() - 1;
  AxisOperator outflow(grid.v_cell_count(), half);
  for (int b = 0; b < half; ++b)
    outflow.insert(cell_of_motion_into_wall(grid, AxisEnd::right, b), b) = -1.0;
  const AxisOperator out_of_column =
      single_entry_matrix(grid.nx(), 1, last, 0, 1 / grid.x1.cell_width(last));
  return kronecker_product(out_of_column, outflow) *
         wall_flux_matrix(grid, scheme_order, AxisEnd::right);
}

// Returns the matrix of the term d/dx2 [ x2^power p ], by fluxes through the inner cell faces of
// x2. The matrix `values` maps cell averages of the density p to values of p on the cell faces.
AxisOperator power_divergence_matrix(const GridAxis& x2, int power, const AxisOperator& values) {
  AxisOperator factor(x2.cell_count() + 1, x2.cell_count() + 1);
  for (int f = 0; f <= x2.cell_count(); ++f)
    factor.insert(f, f) = std::pow(x2.face_position(f), power);
  return divergence_operator(x2) * AxisOperator(factor * values);
}

// Matrices that map averages of the density over velocity cells to values and derivatives of the
// density on the velocity faces.
struct VelocityFaceReconstruction {
  AxisOperator centred, derivative, jump;  // jump: value from the left minus value from the right
};

// Returns the one-sided limits of the force at the velocity x2 = 0, for x2 < 0 and for x2 > 0.
std::pair<double, double> one_sided_forces(const problem::System& system, double x1,
                                           const PhasePlaneGrid& grid) {
  // At the velocity `small` the force differs from the one-sided limit at x2 = 0 only by rounding
  // errors.
  const double small = 1e-12 * grid.x2_max();
  return {system.force(x1, -small), system.force(x1, small)};
}

// Returns the kink of the density at the velocity x2 = 0 for each cell of x1, where the force is
// discontinuous under diffusion. The list of kinks is empty if the density has no kink at x2 = 0,
// and under multiplicative noise, for which no stencils for kinks exist.
std::vector<DensityKink> density_kinks(const problem::System& system,
                                       const DiscretisedExcitation& excitation,
                                       const PhasePlaneGrid& grid) {
  const double diffusion = excitation.diffusion;
  if (!system.has_force_jumps_in_v() || diffusion <= 0 || excitation.state_dependent_diffusion)
    return {};
  std::vector<DensityKink> kinks;
  for (int i = 0; i < grid.nx(); ++i) {
    const auto [below, above] = one_sided_forces(system, grid.x1.cell_centre(i), grid);
    kinks.push_back({.decay = (above - below) / (2 * diffusion),
                     .drift = ((above + below) / 2 - excitation.drift) / diffusion});
  }
  return kinks;
}

// Returns the reconstructions of the density on the faces of the velocity x2: one reconstruction
// for all cells of x1 or, for a density with kinks, one reconstruction for each cell of x1.
std::vector<VelocityFaceReconstruction> face_reconstructions(
    const GridAxis& x2, int scheme_order, const std::vector<DensityKink>& kinks) {
  const int centred = centred_stencil_size(scheme_order);
  const auto reconstruction = [&](const auto&... kink) {
    return VelocityFaceReconstruction{
        face_value_operator(x2, centred, UpstreamSideOfFace::left, kink...),
        face_derivative_operator(x2, centred, kink...),
        face_value_operator(x2, scheme_order, UpstreamSideOfFace::left, kink...) -
            face_value_operator(x2, scheme_order, UpstreamSideOfFace::right, kink...)};
  };
  std::vector<VelocityFaceReconstruction> all;
  if (kinks.empty()) all.push_back(reconstruction());
  for (const DensityKink& kink : kinks) all.push_back(reconstruction(kink));
  return all;
}

// Returns the matrix of the term d/dx2 [ weight(x1, x2) L p ], by fluxes through the inner cell
// faces of x2, where L is a linear operator in x2. The function `weight` is used at each velocity
// face as a weight of the averages over cells of x1. The matrix values_of(column) maps averages
// over velocity cells to the values of L p on the velocity faces, for one cell of x1.
template <class ValuesOf, class Weight>
SparseColumnMatrix weighted_divergence_matrix(const PhasePlaneGrid& grid, int weight_stencil_size,
                                              const ValuesOf& values_of, const Weight& weight) {
  const GridAxis& x2 = grid.x2;
  const int nv = grid.v_cell_count();
  const WeightedAverageMatrixBuilder averages(grid.x1, weight_stencil_size);
  std::vector<Eigen::Triplet<double>> entries;
  for (int face = 1; face < nv; ++face) {
    const double at = x2.face_position(face);
    const AxisOperator of_face =
        averages.weighted_average_matrix([&](double x1) { return weight(x1, at); });
    for (int i = 0; i < grid.nx(); ++i) {
      for (AxisOperator::InnerIterator of_x1(of_face, i); of_x1; ++of_x1) {
        const AxisOperator& values = values_of(of_x1.col());
        for (AxisOperator::InnerIterator of_x2(values, face); of_x2; ++of_x2) {
          const double flux = of_x1.value() * of_x2.value();
          const auto column = of_x1.col() * nv + of_x2.col();
          entries.emplace_back(i * nv + face - 1, column, flux / x2.cell_width(face - 1));
          entries.emplace_back(i * nv + face, column, -flux / x2.cell_width(face));
        }
      }
    }
  }
  SparseColumnMatrix matrix(grid.nx() * nv, grid.nx() * nv);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Returns the matrix of the term d/dx2 [ f(x1, x2) p ] for a force f that is given by a formula. On
// a cell face at which the force f is discontinuous, the mean of the one-sided forces is used.
SparseColumnMatrix formula_force_matrix(
    const problem::System& system, const PhasePlaneGrid& grid,
    const std::vector<VelocityFaceReconstruction>& reconstructions, int weight_stencil_size) {
  const bool has_kinks = reconstructions.size() > 1;
  return weighted_divergence_matrix(
      grid, weight_stencil_size,
      [&](Eigen::Index column) -> const AxisOperator& {
        return reconstructions[has_kinks ? column : 0].centred;
      },
      [&](double x1, double x2) {
        if (!has_kinks || x2 != 0) return system.force(x1, x2);
        const auto [below, above] = one_sided_forces(system, x1, grid);
        return (below + above) / 2;
      });
}

// Returns the matrix of the term d^2/dx2^2 [ D(x1, x2) p ], as the divergence of the flux D p' + D'
// p, where the prime is the derivative with respect to x2.
SparseColumnMatrix variable_diffusion_matrix(const StateDependentDiffusion& diffusion,
                                             const PhasePlaneGrid& grid,
                                             const VelocityFaceReconstruction& reconstruction,
                                             int weight_stencil_size) {
  SparseColumnMatrix matrix = weighted_divergence_matrix(
      grid, weight_stencil_size,
      [&](Eigen::Index) -> const AxisOperator& { return reconstruction.derivative; },
      diffusion.coefficient);
  if (diffusion.slope_in_x2) {
    matrix += weighted_divergence_matrix(
        grid, weight_stencil_size,
        [&](Eigen::Index) -> const AxisOperator& { return reconstruction.centred; },
        diffusion.slope_in_x2);
  }
  return matrix;
}

// Returns the block-diagonal matrix of operators in the velocity x2, one for each cell of x1.
SparseColumnMatrix block_diagonal_matrix(const std::vector<AxisOperator>& blocks) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index row = 0, column = 0;
  for (const AxisOperator& block : blocks) {
    for (int r = 0; r < block.outerSize(); ++r) {
      for (AxisOperator::InnerIterator e(block, r); e; ++e) {
        entries.emplace_back(row + e.row(), column + e.col(), e.value());
      }
    }
    row += block.rows();
    column += block.cols();
  }
  SparseColumnMatrix matrix(row, column);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Returns the matrix of drift and diffusion of the excitation for densities with kinks.
SparseColumnMatrix kinked_drift_diffusion_matrix(
    const GridAxis& x2, const DiscretisedExcitation& excitation,
    const std::vector<VelocityFaceReconstruction>& reconstructions) {
  const AxisOperator divergence = divergence_operator(x2);
  std::vector<AxisOperator> blocks;
  for (const VelocityFaceReconstruction& reconstruction : reconstructions) {
    blocks.push_back(divergence * AxisOperator(excitation.diffusion * reconstruction.derivative -
                                               excitation.drift * reconstruction.centred));
  }
  return block_diagonal_matrix(blocks);
}

// Returns the matrix of the term d/dx2 [ (c(x1) x2 + c_vv x2^3 + g(x1)) p ], of damping and
// restoring force, by fluxes through the inner cell faces of x2.
SparseColumnMatrix damping_and_force_matrix(
    const problem::System& system, const PhasePlaneGrid& grid,
    const std::vector<VelocityFaceReconstruction>& reconstructions, int weight_stencil_size) {
  if (!system.has_polynomial_force()) {
    return formula_force_matrix(system, grid, reconstructions, weight_stencil_size);
  }
  const GridAxis& x2 = grid.x2;
  const AxisOperator& values = reconstructions.front().centred;
  const AxisOperator force =
      weighted_average_operator(grid.x1, weight_stencil_size, system.restoring_force());
  // Constant damping does not couple the cells of x1, so that the matrix remains sparse.
  const AxisOperator damping =
      system.has_constant_damping()
          ? AxisOperator(system.damping() * identity_matrix(grid.nx()))
          : weighted_average_operator(grid.x1, weight_stencil_size, system.damping_polynomial());
  SparseColumnMatrix sum = kronecker_product(damping, power_divergence_matrix(x2, 1, values)) +
                           kronecker_product(force, divergence_operator(x2) * values);
  if (system.rayleigh_coefficient() != 0) {
    sum +=
        kronecker_product(identity_matrix(grid.nx()),
                          system.rayleigh_coefficient() * power_divergence_matrix(x2, 3, values));
  }
  return sum;
}

// Returns the difference between the upwind-biased and the centred transport terms in x2, for odd
// orders. With the acceleration a = -(c(x1) x2 + c_vv x2^3 + g(x1)) the upwind flux in x2 is
//     a (p_left + p_right)/2 + |a| (p_left - p_right)/2.
// The first term of this upwind flux is the centred flux of the next even order.
SparseColumnMatrix upwind_correction_matrix(
    const problem::System& system, const PhasePlaneGrid& grid,
    const std::vector<VelocityFaceReconstruction>& reconstructions) {
  const GridAxis& x1 = grid.x1;
  const GridAxis& x2 = grid.x2;
  const AxisOperator columns = identity_matrix(grid.nx());
  SparseColumnMatrix flux;
  if (reconstructions.size() == 1) {
    flux = kronecker_product(columns, reconstructions.front().jump);
  } else {
    std::vector<AxisOperator> jumps;
    for (const VelocityFaceReconstruction& reconstruction : reconstructions)
      jumps.push_back(reconstruction.jump);
    flux = block_diagonal_matrix(jumps);
  }
  const int faces = grid.v_cell_count() + 1;
  Eigen::VectorXd half_speeds(flux.rows());  // |a|/2 on each face
  for (int i = 0; i < grid.nx(); ++i) {
    for (int face = 0; face < faces; ++face) {
      half_speeds[i * faces + face] =
          0.5 * std::abs(system.force(x1.cell_centre(i), x2.face_position(face)));
    }
  }
  // The entries are scaled in place, since Eigen's product (-half_speeds).asDiagonal() * flux
  // copies the whole diagonal for each column.
  for (Eigen::Index column = 0; column < flux.cols(); ++column) {
    for (SparseColumnMatrix::InnerIterator entry(flux, column); entry; ++entry) {
      entry.valueRef() *= -half_speeds[entry.row()];
    }
  }
  return kronecker_product(columns, divergence_operator(x2)) * flux;
}

// Adds the matrix product E P A^T to the rate of change, with E = of_x2 and A = of_x1, where each
// column of P contains the cell averages at one x1. Row i of the matrix A is empty if the factor
// b(x1) of the impulses in cell i is far from the interpolation value b_m.
void add_parametric_jumps(const AxisOperator& of_x1, const Eigen::MatrixXd& of_x2,
                          const Eigen::Map<const Eigen::MatrixXd>& cell_averages,
                          Eigen::Map<Eigen::MatrixXd>& rate) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < of_x1.rows(); ++i) {
    if (of_x1.innerVector(i).nonZeros() > 0) rows.push_back(i);
  }
  Eigen::MatrixXd averaged =
      Eigen::MatrixXd::Zero(of_x2.rows(), static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto column = averaged.col(static_cast<Eigen::Index>(k));
    for (AxisOperator::InnerIterator e(of_x1, rows[k]); e; ++e) {
      column += e.value() * cell_averages.col(e.col());
    }
  }
  const Eigen::MatrixXd jumped = of_x2 * averaged;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rate.col(rows[k]) += jumped.col(static_cast<Eigen::Index>(k));
  }
}

}  // namespace

SparseColumnMatrix scale_and_shift_matrix(double factor, const SparseColumnMatrix& matrix,
                                          double shift) {
  SparseColumnMatrix unit(matrix.rows(), matrix.cols());
  unit.setIdentity();
  return factor * matrix + shift * unit;
}

SparseColumnMatrix wall_flux_matrix(const PhasePlaneGrid& grid, int scheme_order, AxisEnd end) {
  const int half = grid.v_cell_count() / 2;
  const bool left = end == AxisEnd::left;
  // The density on the wall is discontinuous at the velocity x2 = 0, so that a stencil contains
  // only cells with one sign of x2.
  const AxisOperator speed =
      weighted_average_operator(grid.x2, averaging_stencil_size(scheme_order),
                                numerics::Polynomial({0, left ? -1.0 : 1.0}), half);
  AxisOperator in_order(half, grid.v_cell_count());
  for (int b = 0; b < half; ++b) in_order.insert(b, cell_of_motion_into_wall(grid, end, b)) = 1.0;
  return kronecker_product(end_value_operator(grid.x1, end, scheme_order),
                           AxisOperator(in_order * speed));
}

FokkerPlanckOperator fokker_planck_operator(const problem::System& system,
                                            const DiscretisedExcitation& excitation,
                                            problem::ImpactCondition impact,
                                            const PhasePlaneGrid& grid, int scheme_order,
                                            CellAverageProductRule averaging) {
  const int weight_stencil_size =
      averaging == CellAverageProductRule::full ? averaging_stencil_size(scheme_order) : 1;
  const std::vector<DensityKink> kinks = density_kinks(system, excitation, grid);
  SparseColumnMatrix local =
      streaming_matrix(grid, scheme_order, weight_stencil_size, !kinks.empty());
  if (system.left_wall()) {
    local += wall_exchange_matrix(*system.left_wall(), impact, grid, scheme_order, AxisEnd::left);
  }
  if (grid.x1.right_end_condition() == AxisEndCondition::barrier) {
    local += barrier_outflow_matrix(grid, scheme_order);
  } else if (system.right_wall()) {
    local += wall_exchange_matrix(*system.right_wall(), impact, grid, scheme_order, AxisEnd::right);
  }
  const auto reconstructions = face_reconstructions(grid.x2, scheme_order, kinks);
  local += damping_and_force_matrix(system, grid, reconstructions, weight_stencil_size);
  local += kinks.empty()
               ? kronecker_product(identity_matrix(grid.nx()),
                                   drift_diffusion_matrix(grid.x2, excitation,
                                                          centred_stencil_size(scheme_order)))
               : kinked_drift_diffusion_matrix(grid.x2, excitation, reconstructions);
  if (excitation.state_dependent_diffusion) {
    local += variable_diffusion_matrix(*excitation.state_dependent_diffusion, grid,
                                       reconstructions.front(), weight_stencil_size);
  }
  if (scheme_order % 2 == 1) local += upwind_correction_matrix(system, grid, reconstructions);
  local.prune(0.0);
  local.makeCompressed();
  std::vector<NonlocalExcitationTerm> exchange;
  if (excitation.parametric) {
    exchange = parametric_exchange_terms(*excitation.parametric, grid, weight_stencil_size);
  } else if (excitation.exchange.size() > 0) {
    exchange.push_back({std::nullopt, excitation.exchange});
  }
  return {std::move(local), std::move(exchange), grid.cell_areas()};
}

Eigen::VectorXd FokkerPlanckOperator::operator*(const Eigen::VectorXd& cell_averages) const {
  Eigen::VectorXd rate = local * cell_averages;
  for (const auto& [of_x1, of_x2] : exchange) {
    const Eigen::Index nv = of_x2.rows(), nx = cell_averages.size() / nv;
    const Eigen::Map<const Eigen::MatrixXd> from(cell_averages.data(), nv, nx);
    Eigen::Map<Eigen::MatrixXd> to(rate.data(), nv, nx);
    if (of_x1) {
      add_parametric_jumps(*of_x1, of_x2, from, to);
    } else {
      to.noalias() += of_x2 * from;
    }
  }
  return rate;
}

Eigen::VectorXd FokkerPlanckOperator::transposed_product(const Eigen::VectorXd& x) const {
  Eigen::VectorXd product = local.transpose() * x;
  for (const auto& [of_x1, of_x2] : exchange) {
    const Eigen::Index nv = of_x2.rows(), nx = x.size() / nv;
    const Eigen::MatrixXd jumped =
        of_x2.transpose() * Eigen::Map<const Eigen::MatrixXd>(x.data(), nv, nx);
    Eigen::Map<Eigen::MatrixXd> to(product.data(), nv, nx);
    if (of_x1) {
      to += jumped * *of_x1;
    } else {
      to += jumped;
    }
  }
  return product;
}

SparseColumnMatrix FokkerPlanckOperator::assembled_matrix() const {
  // Velocity jumps by a whole number of cells cause rounding errors in matrix entries whose exact
  // value is zero.
  constexpr double kRounding = 1e-14;
  SparseColumnMatrix matrix = local;
  for (const auto& [of_x1, of_x2] : exchange) {
    matrix += kronecker_product(
        of_x1 ? *of_x1 : identity_matrix(static_cast<int>(areas.size() / of_x2.rows())),
        of_x2.sparseView(of_x2.cwiseAbs().maxCoeff(), kRounding));
  }
  return matrix;
}

double FokkerPlanckOperator::max_mass_loss_rate() const {
  return transposed_product(areas).cwiseQuotient(areas).cwiseAbs().maxCoeff();
}

double FokkerPlanckOperator::stationarity_residual(const Eigen::VectorXd& cell_averages) const {
  return areas.dot((*this * cell_averages).cwiseAbs()) / areas.dot(cell_averages.cwiseAbs());
}

}  // namespace fpkcheck::fd_fpk
