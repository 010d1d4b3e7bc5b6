#include "fd_fpk/characteristics/embedded_chain.hpp"

#include <algorithm>

#include "fd_fpk/characteristics/aggregation.hpp"
#include "fd_fpk/line/cell_jumps.hpp"
#include "fd_fpk/linear/gmres.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

class Chain {
 public:
  Chain(const problem::Problem& problem, const Grid& grid, int characteristics_per_cell)
      : grid_(grid),
        jumps_(cell_jumps(grid.x2, problem.impulses.law())),
        characteristics_(problem.system, grid, problem.impulses.arrival_rate(),
                         characteristics_per_cell),
        passage_(characteristics_),
        tilts_after_(grid),
        tilts_before_(grid) {}

  const Characteristics& characteristics() const { return characteristics_; }

  // From q to p.
  Eigen::VectorXd carried(const Eigen::VectorXd& after, ImpactSums* impacts = nullptr) const {
    return passage_(after, tilted_ ? tilts_after_(after) : none(), impacts);
  }

  // From p to q.
  Eigen::VectorXd kicked(const Eigen::VectorXd& before) const {
    Eigen::VectorXd after(before.size());
    columns(after).noalias() = jumps_.even * columns(before);
    if (tilted_) {
      const Eigen::VectorXd tilts = tilts_before_.in_v(before);
      columns(after).noalias() += jumps_.tilt * columns(tilts);
    }
    return after;
  }

  void tilt_within(const Eigen::VectorXd& after) {
    tilted_ = true;
    tilts_after_.limit_by(after);
    tilts_before_.limit_by(carried_evenly(after));
  }

 private:
  Tilts none() const {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(grid_.size());
    return {zero, zero};
  }
  Eigen::VectorXd carried_evenly(const Eigen::VectorXd& after) const {
    return passage_(after, none());
  }
  // The masses of each cell of x1 as a column.
  Eigen::Map<Eigen::MatrixXd> columns(Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.nv(), grid_.nx()};
  }
  Eigen::Map<const Eigen::MatrixXd> columns(const Eigen::VectorXd& masses) const {
    return {masses.data(), grid_.nv(), grid_.nx()};
  }

  const Grid& grid_;
  CellJumps jumps_;
  Characteristics characteristics_;
  Passage passage_;
  TiltRule tilts_after_, tilts_before_;
  bool tilted_ = false;
};

// Of the residual. Without tilts q is only what limits them.
constexpr double kTolerance = 1e-10, kRoughTolerance = 1e-9;

// Improves q, of mass 1, by GMRES: (1 - J T) d + q (1, d) = J T q - q, where d has no mass.
void improve(const Chain& chain, const Aggregation& aggregation, double tolerance,
             const Deadline& deadline, Eigen::VectorXd& after, StationaryMasses& result) {
  const Eigen::VectorXd defect = chain.kicked(chain.carried(after)) - after;
  const double norm = defect.cwiseAbs().sum();
  if (norm <= tolerance) return;
  const LinearMap map = [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
    return d - chain.kicked(chain.carried(d)) + after * d.sum();
  };
  const ApproximateSolve correct = [&](Eigen::Ref<Eigen::VectorXd> d) { aggregation.correct(d); };
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

// The more impulses it takes to forget, the more of the error is slow.
int blocks_for(const problem::Problem& problem) {
  constexpr double kPerImpulse = 20;
  return static_cast<int>(
      std::clamp(kPerImpulse * problem::impulses_per_decay_time(problem), 200.0, 1600.0));
}

}  // namespace

StationaryMasses stationary_masses(const problem::Problem& problem, const Grid& grid,
                                   int characteristics_per_cell, const Deadline& deadline) {
  Chain chain(problem, grid, characteristics_per_cell);
  Aggregation aggregation(grid, blocks_for(problem));
  {
    const Chain of_blocks(problem, aggregation.blocks(), characteristics_per_cell);
    aggregation.set_chain(
        [&](const Eigen::VectorXd& after) { return of_blocks.kicked(of_blocks.carried(after)); });
  }
  const RestCells& rest = chain.characteristics().rest();
  StationaryMasses result{.masses = std::nullopt,
                          .rest = rest,
                          .visits = static_cast<long>(chain.characteristics().visits().size())};
  // The first impulse finds the oscillator at rest.
  Eigen::VectorXd start = Eigen::VectorXd::Zero(grid.size());
  start(rest.below) = start(rest.above) = 0.5;
  Eigen::VectorXd after = chain.kicked(start);
  improve(chain, aggregation, kRoughTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  chain.tilt_within(after);
  aggregation.spread_like(after);
  improve(chain, aggregation, kTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  const Eigen::VectorXd before = chain.carried(after, &result.impacts);
  result.residual = (chain.kicked(before) - after).cwiseAbs().sum();
  result.masses = before / before.sum();
  return result;
}

}  // namespace fpkcheck::fd_fpk
