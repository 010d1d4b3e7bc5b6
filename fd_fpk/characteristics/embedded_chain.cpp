#include "fd_fpk/characteristics/embedded_chain.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/process/parallel_for.hpp"
#include "fd_fpk/axis/jump_matrix.hpp"
#include "fd_fpk/linear/gmres.hpp"

namespace fpkcheck::fd_fpk {
namespace {

std::vector<double> keep_every_nth_face(const std::vector<double>& faces, int stride) {
  std::vector<double> kept;
  for (std::size_t f = 0; f + 1 < faces.size(); f += static_cast<std::size_t>(stride)) {
    kept.push_back(faces[f]);
  }
  kept.push_back(faces.back());
  return kept;
}

PhasePlaneGrid coarsened_grid(const PhasePlaneGrid& grid, int stride) {
  return symmetric_grid(keep_every_nth_face(grid.x1.faces(), stride),
                        keep_every_nth_face(grid.speed_axis().faces(), stride),
                        grid.x1.left_end_condition(), grid.x1.right_end_condition());
}

int block_stride(const PhasePlaneGrid& grid, int max_blocks) {
  int stride = 1;
  const auto count = [&](int cells) { return (cells + stride - 1) / stride; };
  while (count(grid.nx()) * 2 * count(grid.v_cell_count() / 2) > max_blocks) ++stride;
  return stride;
}

std::vector<int> block_indices(const GridAxis& axis, const GridAxis& blocks) {
  std::vector<int> block(axis.cell_count());
  int b = 0;
  for (int i = 0; i < axis.cell_count(); ++i) {
    while (axis.cell_centre(i) > blocks.face_position(b + 1)) ++b;
    block[i] = b;
  }
  return block;
}

}  // namespace

MarkovChainAggregation::MarkovChainAggregation(const PhasePlaneGrid& grid, int atom_count,
                                               int max_blocks)
    : grid_(grid),
      atoms_(atom_count),
      blocks_(coarsened_grid(grid, block_stride(grid, max_blocks))) {
  block_of_y_ = block_indices(grid.x1, blocks_.x1);
  block_of_v_ = block_indices(grid.x2, blocks_.x2);
  set_disaggregation_weights(Eigen::VectorXd::Zero(grid.size() + atom_count));
}

void MarkovChainAggregation::set_chain_of_cell_blocks(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& step) {
  const int count = blocks_.size() + atoms_;
  Eigen::MatrixXd system(count, count);
  Eigen::VectorXd one = Eigen::VectorXd::Zero(count);
  for (int b = 0; b < count; ++b) {
    one(b) = 1;
    system.col(b) = one - step(one);
    one(b) = 0;
  }
  // The singular matrix I - A of a Markov chain with the transition matrix A becomes nonsingular by
  // the added term start 1^T, with `start` proportional to the areas of the blocks of cells.
  Eigen::VectorXd added = Eigen::VectorXd::Zero(count);
  added.head(blocks_.size()) = blocks_.cell_areas() / blocks_.cell_areas().sum();
  system.colwise() += added;
  factors_.compute(system);
}

void MarkovChainAggregation::set_disaggregation_weights(const Eigen::VectorXd& masses) {
  constexpr double kEven = 1e-6;  // fraction of the total mass that is distributed evenly
  const Eigen::VectorXd areas = grid_.cell_areas();
  weights_ = masses.cwiseMax(0);
  weights_.head(grid_.size()) += kEven / areas.sum() * areas;
  const Eigen::VectorXd sums = sum_masses_over_blocks(weights_);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.v_cell_count(); ++j) {
      weights_(i * grid_.v_cell_count() + j) /=
          sums(block_of_y_[i] * blocks_.v_cell_count() + block_of_v_[j]);
    }
  }
}

Eigen::VectorXd MarkovChainAggregation::sum_masses_over_blocks(
    const Eigen::Ref<const Eigen::VectorXd>& masses) const {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(blocks_.size() + atoms_);
  sums.tail(atoms_) = masses.tail(atoms_);
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.v_cell_count(); ++j) {
      sums(block_of_y_[i] * blocks_.v_cell_count() + block_of_v_[j]) +=
          masses(i * grid_.v_cell_count() + j);
    }
  }
  return sums;
}

void MarkovChainAggregation::apply_coarse_correction(Eigen::Ref<Eigen::VectorXd> masses) const {
  const Eigen::VectorXd sums = sum_masses_over_blocks(masses);
  const Eigen::VectorXd missing = factors_.solve(sums) - sums;
  for (int i = 0; i < grid_.nx(); ++i) {
    for (int j = 0; j < grid_.v_cell_count(); ++j) {
      const int cell = i * grid_.v_cell_count() + j;
      masses(cell) +=
          weights_(cell) * missing(block_of_y_[i] * blocks_.v_cell_count() + block_of_v_[j]);
    }
  }
  masses.tail(atoms_) += missing.tail(atoms_);
}

namespace {

class EmbeddedMarkovChain {
 public:
  EmbeddedMarkovChain(const problem::Problem& problem, const PhasePlaneGrid& grid,
                      int characteristics_per_cell, const base::Deadline& deadline)
      : grid_(grid),
        jumps_(cell_jump_matrices(grid.x2, problem.impulses.amplitude_law())),
        characteristics_(problem.system, grid, problem.impulses.arrival_rate(),
                         characteristics_per_cell, deadline),
        transport_(characteristics_, problem.impulses.amplitude_law()),
        slopes_after_(grid, characteristics_.rest_points()),
        slopes_before_(grid, characteristics_.rest_points()) {}

  const Characteristics& characteristics() const { return characteristics_; }

  // Returns the masses after the next impulse, or at the end of a characteristic without an
  // impulse.
  Eigen::VectorXd apply_step(const Eigen::VectorXd& masses_after_impulse) const {
    const auto [ended, continuing] = apply_flow(masses_after_impulse);
    return apply_jump(ended) + continuing;
  }

  // Applies the transport operator: maps masses after an impulse to masses before the next impulse.
  TransportOperator::TransportedMasses apply_flow(const Eigen::VectorXd& masses_after_impulse,
                                                  ImpactSumsOfBothWalls* impacts = nullptr) const {
    return transport_(masses_after_impulse,
                      has_slopes_ ? slopes_after_(masses_after_impulse) : zero_slopes(), impacts);
  }

  // Applies the velocity jumps to all mass except the mass at rest in contact, whose jumps the
  // transport operator includes.
  Eigen::VectorXd apply_jump(const Eigen::VectorXd& masses_before_impulse) const {
    Eigen::VectorXd masses_after_impulse = masses_before_impulse;
    const Eigen::VectorXd slopes =
        has_slopes_ ? slopes_before_.density_velocity_slopes(masses_before_impulse)
                    : Eigen::VectorXd();
    constexpr int kParts = 4;
    base::parallel_for(kParts, base::kOneThreadPerProcessor, [&](std::size_t k) {
      const auto part = static_cast<int>(k);
      const int first = grid_.nx() * part / kParts, last = grid_.nx() * (part + 1) / kParts;
      const auto columns = [&](auto& masses) {
        return velocity_columns(masses).middleCols(first, last - first);
      };
      columns(masses_after_impulse).noalias() = jumps_.uniform * columns(masses_before_impulse);
      if (has_slopes_) columns(masses_after_impulse).noalias() += jumps_.slope * columns(slopes);
    });
    return masses_after_impulse;
  }

  void enable_slopes(const Eigen::VectorXd& masses_after_impulse) {
    has_slopes_ = true;
    slopes_after_.set_slope_limiter(masses_after_impulse);
    slopes_before_.set_slope_limiter(apply_flow_without_slopes(masses_after_impulse));
  }

 private:
  DensitySlopesInCells zero_slopes() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(grid_.size());
    return {zero, zero};
  }
  Eigen::VectorXd apply_flow_without_slopes(const Eigen::VectorXd& masses_after_impulse) const {
    return transport_(masses_after_impulse, zero_slopes()).ended;
  }
  // Returns the masses of all grid cells as a matrix with one column for each cell of x1.
  Eigen::Map<Eigen::MatrixXd> velocity_columns(Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.v_cell_count(), grid_.nx()};
  }
  Eigen::Map<const Eigen::MatrixXd> velocity_columns(const Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.v_cell_count(), grid_.nx()};
  }

  const PhasePlaneGrid& grid_;
  CellJumpMatrices jumps_;
  Characteristics characteristics_;
  TransportOperator transport_;
  DensitySlopeReconstruction slopes_after_, slopes_before_;
  bool has_slopes_ = false;
};

// Tolerances of the residual of the embedded Markov chain, in the L1 norm; the rough tolerance is
// for the first solution, which only determines the slope limiter.
constexpr double kChainTolerance = 1e-10, kRoughChainTolerance = 1e-9;

// Adds to the density q of mass 1 the correction d of mass 0 that solves d - A d + q (1, d) = A q -
// q, where A is one step of the embedded Markov chain.
void solve_chain_by_gmres(const EmbeddedMarkovChain& chain,
                          const MarkovChainAggregation& aggregation, double tolerance,
                          const base::Deadline& deadline, Eigen::VectorXd& masses_after_impulse,
                          StationaryCellMasses& result) {
  const Eigen::VectorXd defect = chain.apply_step(masses_after_impulse) - masses_after_impulse;
  const double norm = defect.cwiseAbs().sum();
  if (norm <= tolerance) return;
  const LinearMap map = [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
    return d - chain.apply_step(d) + masses_after_impulse * d.sum();
  };
  const ApproximateLinearSolver correct = [&](Eigen::Ref<Eigen::VectorXd> d) {
    aggregation.apply_coarse_correction(d);
  };
  const auto found =
      solve_by_gmres(map, correct, defect, Eigen::VectorXd::Ones(masses_after_impulse.size()),
                     tolerance / norm, deadline);
  result.iterations += found.iterations;
  if (!found.solution) {
    result.failure = found.failure;
    return;
  }
  masses_after_impulse += *found.solution;
  masses_after_impulse /= masses_after_impulse.sum();
}

// Under many impulses per decay time the embedded Markov chain converges slowly and requires more
// blocks than under rare impulses.
int max_block_count(const problem::Problem& problem, const problem::MotionScales& scales) {
  constexpr double kPerImpulse = 20;
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  return static_cast<int>(std::clamp(kPerImpulse * impulses, 200.0, 1600.0));
}

}  // namespace

StationaryCellMasses stationary_cell_masses(const problem::Problem& problem,
                                            const problem::MotionScales& scales,
                                            const PhasePlaneGrid& grid,
                                            int characteristics_per_cell,
                                            const base::Deadline& deadline) {
  EmbeddedMarkovChain chain(problem, grid, characteristics_per_cell, deadline);
  const auto& characteristics = chain.characteristics();
  const auto& points = characteristics.rest_points();
  if (const std::string why = characteristics.failure_reason(); !why.empty()) {
    return {.masses = std::nullopt,
            .failure = why,
            .visits = static_cast<long>(characteristics.characteristic_cell_visits().size())};
  }
  const auto atoms = static_cast<int>(characteristics.indices_of_rest_points_in_contact().size());
  MarkovChainAggregation aggregation(grid, atoms, max_block_count(problem, scales));
  {
    const EmbeddedMarkovChain block_chain(problem, aggregation.coarse_grid_of_cell_blocks(),
                                          characteristics_per_cell, deadline);
    if (const std::string why = block_chain.characteristics().failure_reason(); !why.empty()) {
      return {.masses = std::nullopt, .failure = why};
    }
    aggregation.set_chain_of_cell_blocks([&](const Eigen::VectorXd& masses_after_impulse) {
      return block_chain.apply_step(masses_after_impulse);
    });
  }
  StationaryCellMasses result{
      .masses = std::nullopt,
      .rest = points,
      .visits = static_cast<long>(characteristics.characteristic_cell_visits().size())};
  // The initial density is concentrated at rest; for a problem without a rest point, the initial
  // density is uniform.
  Eigen::VectorXd start = Eigen::VectorXd::Zero(grid.size() + atoms);
  for (const RestPoint& point : points) {
    if (point.contact) continue;
    for (const auto& [cell, share] : point.cells) start(cell) = share;
  }
  start.tail(atoms).setOnes();
  if (points.empty()) start = grid.cell_areas();
  start /= start.sum();
  Eigen::VectorXd masses_after_impulse = chain.apply_jump(start);
  solve_chain_by_gmres(chain, aggregation, kRoughChainTolerance, deadline, masses_after_impulse,
                       result);
  if (!result.failure.empty()) return result;
  chain.enable_slopes(masses_after_impulse);
  aggregation.set_disaggregation_weights(masses_after_impulse);
  solve_chain_by_gmres(chain, aggregation, kChainTolerance, deadline, masses_after_impulse, result);
  if (!result.failure.empty()) return result;
  const auto [masses_before_impulse, continuing] =
      chain.apply_flow(masses_after_impulse, &result.impacts);
  result.residual = (chain.apply_jump(masses_before_impulse) + continuing - masses_after_impulse)
                        .cwiseAbs()
                        .sum();
  // The number of impacts is per impulse, that is, per unit mass of the density after an impulse.
  // In a problem with walls every characteristic ends at a wall or at rest, so that the masses
  // between impulses sum to 1.
  assert(!(problem.system.left_wall() || problem.system.right_wall()) || points.empty() ||
         std::abs(continuing.sum()) < 1e-9);
  const Eigen::VectorXd masses = masses_before_impulse / masses_before_impulse.sum();
  result.masses = masses.head(grid.size());
  for (const RestPoint& point : points) {
    double mass = 0;
    for (const auto& [cell, share] : point.cells) mass += masses(cell);
    result.at_rest.push_back(mass);
  }
  for (int k = 0; k < atoms; ++k) {
    result.at_rest[characteristics.indices_of_rest_points_in_contact()[k]] =
        masses(grid.size() + k);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
