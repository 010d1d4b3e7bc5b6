#include "fd_fpk/characteristics/embedded_chain.hpp"

#include <algorithm>

#include "fd_fpk/characteristics/aggregation.hpp"
#include "fd_fpk/line/cell_jumps.hpp"
#include "fd_fpk/linear/gmres.hpp"

namespace fpkcheck::fd_fpk {
namespace {

class Chain {
 public:
  Chain(const problem::Problem& problem, const Grid& grid, int characteristics_per_cell,
        const Deadline& given_up)
      : grid_(grid),
        jumps_(cell_jumps(grid.x2, problem.impulses.law())),
        characteristics_(problem.system, grid, problem.impulses.arrival_rate(),
                         characteristics_per_cell, given_up),
        passage_(characteristics_, problem.impulses.law()),
        tilts_after_(grid, characteristics_.rest_places()),
        tilts_before_(grid, characteristics_.rest_places()) {}

  const Characteristics& characteristics() const { return characteristics_; }

  // p = T q.
  Eigen::VectorXd carried(const Eigen::VectorXd& after, WallImpacts* impacts = nullptr) const {
    return passage_(after, tilted_ ? tilts_after_(after) : none(), impacts);
  }

  // q = J p. The transport operator sets mass at rest in contact in motion.
  Eigen::VectorXd kicked(const Eigen::VectorXd& before) const {
    Eigen::VectorXd after = before;
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
  // The masses of each x1 cell as a column.
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

// Tolerances of the residual. The solution without slopes serves only as the slope limiter, so its
// tolerance is larger.
constexpr double kChainTolerance = 1e-10, kRoughChainTolerance = 1e-9;

// Corrects q, of mass 1, by GMRES: (1 - J T) d + q (1, d) = J T q - q, where d has mass 0.
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

// Slow convergence of the chain (many impulses per decay time) requires more blocks.
int blocks_for(const problem::Problem& problem, const problem::Scales& scales) {
  constexpr double kPerImpulse = 20;
  const double impulses = problem::impulses_per_decay_time(problem, scales);
  return static_cast<int>(std::clamp(kPerImpulse * impulses, 200.0, 1600.0));
}

}  // namespace

StationaryMasses stationary_masses(const problem::Problem& problem, const problem::Scales& scales,
                                   const Grid& grid, int characteristics_per_cell,
                                   const Deadline& deadline) {
  Chain chain(problem, grid, characteristics_per_cell, deadline);
  const auto& characteristics = chain.characteristics();
  const auto& places = characteristics.rest_places();
  if (const std::string why = characteristics.failure(); !why.empty()) {
    return {.masses = std::nullopt,
            .failure = why,
            .visits = static_cast<long>(characteristics.visits().size())};
  }
  const auto atoms = static_cast<int>(characteristics.contacts().size());
  Aggregation aggregation(grid, atoms, blocks_for(problem, scales));
  {
    const Chain of_blocks(problem, aggregation.blocks(), characteristics_per_cell, deadline);
    if (const std::string why = of_blocks.characteristics().failure(); !why.empty()) {
      return {.masses = std::nullopt, .failure = why};
    }
    aggregation.set_chain(
        [&](const Eigen::VectorXd& after) { return of_blocks.kicked(of_blocks.carried(after)); });
  }
  StationaryMasses result{.masses = std::nullopt,
                          .rest = places,
                          .visits = static_cast<long>(characteristics.visits().size())};
  // Initial state: the oscillator at rest.
  Eigen::VectorXd start = Eigen::VectorXd::Zero(grid.size() + atoms);
  for (const RestPlace& place : places) {
    if (place.contact) continue;
    for (const auto& [cell, share] : place.cells) start(cell) = share;
  }
  start.tail(atoms).setOnes();
  start /= start.sum();
  Eigen::VectorXd after = chain.kicked(start);
  improve(chain, aggregation, kRoughChainTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  chain.tilt_within(after);
  aggregation.spread_like(after);
  improve(chain, aggregation, kChainTolerance, deadline, after, result);
  if (!result.failure.empty()) return result;
  const Eigen::VectorXd before = chain.carried(after, &result.impacts);
  result.residual = (chain.kicked(before) - after).cwiseAbs().sum();
  const Eigen::VectorXd masses = before / before.sum();
  result.masses = masses.head(grid.size());
  for (const RestPlace& place : places) {
    double mass = 0;
    for (const auto& [cell, share] : place.cells) mass += masses(cell);
    result.at_rest.push_back(mass);
  }
  for (int k = 0; k < atoms; ++k) {
    result.at_rest[characteristics.contacts()[k]] = masses(grid.size() + k);
  }
  return result;
}

}  // namespace fpkcheck::fd_fpk
