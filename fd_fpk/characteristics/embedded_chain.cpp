#include "fd_fpk/characteristics/embedded_chain.hpp"

#include <algorithm>

#include "fd_fpk/axis/cell_jumps.hpp"
#include "fd_fpk/characteristics/aggregation.hpp"
#include "fd_fpk/linear/gmres.hpp"

namespace fpkcheck::fd_fpk {
namespace {

class Chain {
 public:
  Chain(const problem::Problem& problem, const Grid& grid, int characteristics_per_cell,
        const Deadline& deadline)
      : grid_(grid),
        jumps_(cell_jump_matrices(grid.x2, problem.impulses.law())),
        characteristics_(problem.system, grid, problem.impulses.arrival_rate(),
                         characteristics_per_cell, deadline),
        transport_(characteristics_, problem.impulses.law()),
        slopes_after_(grid, characteristics_.rest_points()),
        slopes_before_(grid, characteristics_.rest_points()) {}

  const Characteristics& characteristics() const { return characteristics_; }

  // Applies the transport operator: p = T q.
  Eigen::VectorXd apply_flow(const Eigen::VectorXd& after, WallImpacts* impacts = nullptr) const {
    return transport_(after, has_slopes_ ? slopes_after_(after) : zero_slopes(), impacts);
  }

  // Applies the velocity jumps: q = J p. The masses in contact are not changed, because the
  // transport operator treats the impulses on mass at rest in contact.
  Eigen::VectorXd apply_jump(const Eigen::VectorXd& before) const {
    Eigen::VectorXd after = before;
    columns(after).noalias() = jumps_.uniform * columns(before);
    if (has_slopes_) {
      const Eigen::VectorXd slopes = slopes_before_.v_slopes(before);
      columns(after).noalias() += jumps_.slope * columns(slopes);
    }
    return after;
  }

  void enable_slopes(const Eigen::VectorXd& after) {
    has_slopes_ = true;
    slopes_after_.set_limiter(after);
    slopes_before_.set_limiter(apply_flow_without_slopes(after));
  }

 private:
  CellSlopes zero_slopes() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(grid_.size());
    return {zero, zero};
  }
  Eigen::VectorXd apply_flow_without_slopes(const Eigen::VectorXd& after) const {
    return transport_(after, zero_slopes());
  }
  // The masses as a matrix, with one column for each cell of x1.
  Eigen::Map<Eigen::MatrixXd> columns(Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.nv(), grid_.nx()};
  }
  Eigen::Map<const Eigen::MatrixXd> columns(const Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.nv(), grid_.nx()};
  }

  const Grid& grid_;
  CellJumpMatrices jumps_;
  Characteristics characteristics_;
  TransportOperator transport_;
  SlopeReconstruction slopes_after_, slopes_before_;
  bool has_slopes_ = false;
};

// Tolerances of the residual. The solution without slopes has a larger tolerance, since it only
// determines the slope limiter.
constexpr double kChainTolerance = 1e-10, kRoughChainTolerance = 1e-9;

// Corrects q, of mass 1, by the solution d of (1 - J T) d + q (1, d) = J T q - q by GMRES, where d
// has mass 0.
void correct_by_gmres(const Chain& chain, const Aggregation& aggregation, double tolerance,
                      const Deadline& deadline, Eigen::VectorXd& after, StationaryMasses& result) {
  const Eigen::VectorXd defect = chain.apply_jump(chain.apply_flow(after)) - after;
  const double norm = defect.cwiseAbs().sum();
  if (norm <= tolerance) return;
  const LinearMap map = [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
    return d - chain.apply_jump(chain.apply_flow(d)) + after * d.sum();
  };
  const ApproximateSolve correct = [&](Eigen::Ref<Eigen::VectorXd> d) {
    aggregation.apply_coarse_correction(d);
  };
  const auto found =
      gmres(map, correct, defect, Eigen::VectorXd::Ones(after.size()), tolerance / norm, deadline);
  result.iterations += found.iterations;
  if (!found.solution) {
    result.failure = found.failure;
    return;
  }
  after += *found.solution;
  after /= after.sum();
}

// Number of blocks of the aggregation. If there are many impulses per decay time, the chain
// converges slowly, and more blocks are required.
int block_count(const problem::Problem& problem, const problem::MotionScales& scales) {
  constexpr double kPerImpulse = 20;
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  return static_cast<int>(std::clamp(kPerImpulse * impulses, 200.0, 1600.0));
}

}  // namespace

StationaryMasses stationary_masses(const problem::Problem& problem,
                                   const problem::MotionScales& scales, const Grid& grid,
                                   int characteristics_per_cell, const Deadline& deadline) {
  Chain chain(problem, grid, characteristics_per_cell, deadline);
  const auto& characteristics = chain.characteristics();
  const auto& points = characteristics.rest_points();
  if (const std::string why = characteristics.failure_reason(); !why.empty()) {
    return {.masses = std::nullopt,
            .failure = why,
            .visits = static_cast<long>(characteristics.visits().size())};
  }
  const auto atoms = static_cast<int>(characteristics.contact_indices().size());
  Aggregation aggregation(grid, atoms, block_count(problem, scales));
  {
    const Chain block_chain(problem, aggregation.block_grid(), characteristics_per_cell, deadline);
    if (const std::string why = block_chain.characteristics().failure_reason(); !why.empty()) {
      return {.masses = std::nullopt, .failure = why};
    }
    aggregation.set_block_chain([&](const Eigen::VectorXd& after) {
      return block_chain.apply_jump(block_chain.apply_flow(after));
    });
  }
  StationaryMasses result{.masses = std::nullopt,
                          .rest = points,
                          .visits = static_cast<long>(characteristics.visits().size())};
  // Initial state: the oscillator at rest.
  Eigen::VectorXd start = Eigen::VectorXd::Zero(grid.size() + atoms);
  for (const RestPoint& point : points) {
    if (point.contact) continue;
    for (const auto& [cell, share] : point.cells) start(cell) = share;
  }
  start.tail(atoms).setOnes();
  start /= start.sum();
  Eigen::VectorXd after = chain.apply_jump(start);
  correct_by_gmres(chain, aggregation, kRoughChainTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  chain.enable_slopes(after);
  aggregation.set_disaggregation_weights(after);
  correct_by_gmres(chain, aggregation, kChainTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  const Eigen::VectorXd before = chain.apply_flow(after, &result.impacts);
  result.residual = (chain.apply_jump(before) - after).cwiseAbs().sum();
  const Eigen::VectorXd masses = before / before.sum();
  result.masses = masses.head(grid.size());
  for (const RestPoint& point : points) {
    double mass = 0;
    for (const auto& [cell, share] : point.cells) mass += masses(cell);
    result.at_rest.push_back(mass);
  }
  for (int k = 0; k < atoms; ++k) {
    result.at_rest[characteristics.contact_indices()[k]] = masses(grid.size() + k);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
