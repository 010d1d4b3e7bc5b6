#include "backward/passage/passage.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "backward/passage/renewal_equation.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/effective_potential.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

using transform::Passage;
using transform::Status;

// The problem below the barrier, in wall coordinates.
struct PassageProblem {
  const problem::Problem& problem;
  double frequency;  // of the motion (problem::MotionScales)
  ChebyshevGrid::Domain domain;
  std::optional<transform::StartState> start;
};

// Hazard and mean passage time from the initial state, computed on one grid. Without an initial
// state the mean time is 0.
using PassageValues = Eigen::Vector2d;
enum PassageValueIndex { kHazard, kMeanFromPoint };

std::string passage_unsupported_reason(const problem::Problem& problem, double barrier) {
  if (problem.noise.is_present()) {
    return "noise acts between impulses, and the motion is not deterministic; use fd or mcs";
  }
  if (problem.impulse_factor) {
    return "the renewal equation needs impulses without a factor; use fd or mcs";
  }
  if (!problem.impulses.amplitude_law().atoms().empty()) {
    return "means over an impulse are smooth functions only for a law with a density; use fd or mcs";
  }
  if (!problem.system.has_polynomial_force()) {
    return "the Taylor series of the motion need a polynomial force; use fd or mcs";
  }
  if (!problem.system.left_wall() && barrier <= problem::motion_scales(problem).y_low) {
    return "the stationary probability below the barrier is negligible";
  }
  return problem::barrier_unsupported_reason(problem, barrier);
}

// Returns the problem with a domain that contains the motion before the barrier and from the
// initial state. The largest impulse widens the range of velocities.
PassageProblem make_passage_problem(const problem::Problem& problem, double barrier,
                                    const std::optional<transform::StartState>& start) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::EffectivePotential potential(problem.system);
  const auto& wall = problem.system.left_wall();
  double y_low = wall ? wall->position : scales.y_low;
  double lowest = potential(barrier), highest = lowest;
  const auto include = [&](double y) {
    lowest = std::min(lowest, potential(y));
    highest = std::max(highest, potential(y));
  };
  for (const double y : potential.extrema()) {
    if (y < barrier) include(y);
  }
  if (wall) include(wall->position);
  if (start) {
    include(start->y);
    highest = std::max(highest, start->ydot * start->ydot / 2 + potential(start->y));
  }
  // Without a wall the potential rises on the left.
  constexpr double kStep = 0.1;
  while (!wall && potential(y_low) < highest) y_low -= kStep * scales.displacement_deviation;
  double speed = std::sqrt(2 * (highest - lowest));
  const auto [most_negative, most_positive] =
      effective_amplitude_range(problem.impulses.amplitude_law());
  const UnforcedMotionSolver motion(problem.system, barrier,
                                    problem.impulses.amplitude_law().deviation(), 1);
  if (motion.acceleration({barrier, 0}) < 0) {
    // Traced backward in time, the trajectory that grazes the barrier reaches the barrier within
    // about one period.
    constexpr double kPeriods = 3, kMaxSpeedRatio = 10;
    const double max_speed = kMaxSpeedRatio * std::max(scales.v_high, speed);
    speed = std::max(
        speed,
        std::min(max_speed,
                 motion.find_largest_backward_speed(
                     {barrier, 0}, kPeriods * 2 * std::numbers::pi / scales.frequency, max_speed)));
  }
  return {.problem = problem,
          .frequency = scales.frequency,
          .domain = {y_low, barrier, speed + std::max(-most_negative, most_positive)},
          .start = start};
}

// Returns the numbers of nodes in y and in v for a number of nodes in v per standard deviation of
// the amplitude. The number of nodes in sqrt(barrier - y) is the number in v for the speed of a
// motion through the domain, plus kMinDeviations standard deviations for the cusp of h at rest on
// the wall. The mean time from rest of case 1 (barrier 1.5, 114.27394) differs from the mean time
// with kMinDeviations = 10 by 6e-6 with kMinDeviations = 2, and by 1e-6 with 4.
std::array<double, 2> choose_node_counts(const PassageProblem& passage,
                                         double nodes_per_deviation) {
  constexpr double kMinDeviations = 4;
  const auto& [y_low, barrier, v_max] = passage.domain;
  const double deviation = passage.problem.impulses.amplitude_law().deviation();
  const double speed = passage.frequency * (barrier - y_low);
  return {std::ceil(nodes_per_deviation * (kMinDeviations + speed / deviation)),
          std::ceil(nodes_per_deviation * 2 * v_max / deviation)};
}

// Solves the renewal equation on a grid. The result is empty if the deadline passes.
// @param hazard approximate hazard; 0 if unknown
// @param panel_refinement factor by which the panels of the quadrature rules are shorter
std::optional<PassageValues> solve_on_grid(const PassageProblem& passage, const ChebyshevGrid& grid,
                                           double panel_refinement, double hazard,
                                           const base::Deadline& deadline) {
  const double rate = passage.problem.impulses.arrival_rate();
  const double shifted_rate = rate - hazard;
  const RenewalEquation equation(passage.problem, grid, shifted_rate, panel_refinement);
  auto operators =
      equation.compute_operators({{rate}, {shifted_rate}, {shifted_rate, 1}}, deadline);
  if (operators.empty()) return std::nullopt;
  const auto factorise = [&](Eigen::MatrixXd& matrix) {
    matrix *= -rate;
    matrix.diagonal().array() += 1;
    return Eigen::PartialPivLU<Eigen::MatrixXd>(matrix);
  };
  const Eigen::VectorXd h = factorise(operators[0].matrix).solve(operators[0].values_of_one);
  // Inverse iteration for the eigenvalue of lambda A that is nearest to 1, and for its right and
  // left eigenvectors
  const auto lu = factorise(operators[1].matrix);
  constexpr int kIterations = 8;
  Eigen::VectorXd right = h, left = Eigen::VectorXd::Ones(grid.node_count());
  double distance = 0;  // distance of the eigenvalue from 1
  for (int n = 0; n < kIterations; ++n) {
    const Eigen::VectorXd next = lu.solve(right);
    distance = left.dot(right) / left.dot(next);
    right = next.normalized();
    left = lu.transpose().solve(left).normalized();
  }
  const double slope = rate * left.dot(operators[2].matrix * right) / left.dot(right);
  PassageValues values = PassageValues::Zero();
  values(kHazard) = hazard + distance / slope;
  if (passage.start) {
    const auto mean =
        equation.integrate_from_state({passage.start->y, passage.start->ydot}, {rate});
    values(kMeanFromPoint) = mean.integral_of_one + rate * mean.node_weights.dot(h);
  }
  return values;
}

}  // namespace

Passage solve_passage(const problem::Problem& problem, const PassageCollocationOptions& options,
                      double barrier, std::optional<transform::StartState> start) {
  const base::Stopwatch stopwatch;
  const base::Deadline deadline(options.max_seconds);
  Passage passage{.id = "characteristics"};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const double wall_barrier = transformed.frame.wall_x(barrier);
  passage.reason = passage_unsupported_reason(transformed, wall_barrier);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  start = transform::passage_start(transformed, wall_barrier, start);
  const PassageProblem below = make_passage_problem(transformed, wall_barrier, start);

  // The dense matrices for this number of nodes take about 1 GB.
  constexpr double kMaxNodes = 5000;
  // Nodes per standard deviation of the amplitude on the first grid, and ratio of consecutive grids
  constexpr double kFirstNodes = 0.96, kRatio = 1.25;
  // Refinement of the panels for one node per standard deviation. Twice as many panels change the
  // mean time of case 1 by a relative 1e-8.
  constexpr double kRefinement = 0.3;
  // The grids are refined until the error is a fraction of the required accuracy, since the errors
  // decrease quickly. For convergence of first order, as under laws whose density jumps, the error
  // is 1 / (kRatio - 1) times the difference from the previous grid.
  constexpr double kTargetFraction = 1e-3, kErrorFactor = 1 / (kRatio - 1);
  std::optional<PassageValues> last;
  PassageValues errors = PassageValues::Constant(HUGE_VAL);
  std::string limit;
  double seconds_of_last_grid = 0;
  const double rate = transformed.impulses.arrival_rate();
  double hazard = 0;
  const auto error = [&] {
    return (errors.array() / last->array().abs().max(std::numeric_limits<double>::min()))
        .maxCoeff();
  };
  for (double nodes = kFirstNodes; !last || error() > kTargetFraction * options.accuracy;
       nodes *= kRatio) {
    const auto [n_y, n_v] = choose_node_counts(below, nodes);
    if (n_y * n_v > kMaxNodes) {
      limit = fmt::format("more than {} nodes are needed", kMaxNodes);
      break;
    }
    const ChebyshevGrid grid(below.domain, static_cast<int>(n_y), static_cast<int>(n_v));
    // The number of nodes grows by the factor kRatio^2, and the computing time of the integrals
    // along all trajectories by kRatio^5.
    const double growth = std::pow(kRatio, 5);
    const base::Stopwatch grid_stopwatch;
    std::optional<PassageValues> values;
    if (deadline.has_time_for(growth * seconds_of_last_grid)) {
      values = solve_on_grid(below, grid, kRefinement * nodes, hazard, deadline);
    }
    if (!values) {
      limit = fmt::format("the time limit of {:g} s is reached; raise --max-seconds",
                          options.max_seconds);
      break;
    }
    if (!values->allFinite()) {
      limit = "the renewal equation has no finite solution; use mcs";
      break;
    }
    seconds_of_last_grid = grid_stopwatch.seconds();
    if (last) errors = kErrorFactor * (*values - *last).cwiseAbs();
    last = values;
    // The next grid continues Newton's method for the hazard. The limit (hazard + rate) / 2
    // shortens a step that would exceed the rate of the impulses.
    hazard = std::clamp((*values)(kHazard), 0.0, (hazard + rate) / 2);
    passage.details = fmt::format("{} x {} nodes", grid.y_node_count(), grid.v_node_count());
  }
  passage.seconds = stopwatch.seconds();
  if (!errors.allFinite()) {
    passage.reason = limit;
    return passage;
  }
  const double found = (*last)(kHazard);
  if (!(found > 0 && found < rate)) {
    passage.reason = fmt::format(
        "the hazard {:.3g} is not between 0 and the rate {:g} of impulses: the nodes are too few, or "
        "the motion passes the barrier without an impulse; use fd or mcs",
        found, rate);
    return passage;
  }
  passage.hazard = {found, errors(kHazard)};
  if (start) passage.mean_from_point = {(*last)(kMeanFromPoint), errors(kMeanFromPoint)};
  passage.status = Status::ok;
  if (!(error() <= options.accuracy)) {
    passage.status = Status::inaccurate;
    passage.reason = fmt::format("estimated relative error {:.2g}, above the accuracy {:g}; {}",
                                 error(), options.accuracy, limit);
  }
  return passage;
}

}  // namespace fpkcheck::backward
