#include "backward/passage/passage.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "backward/passage/renewal_equation.hpp"
#include "base/process/stopwatch.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::backward {
namespace {

using transform::Passage;
using transform::Status;

// The problem below the barrier, in wall coordinates.
struct PassageProblem {
  const problem::Problem& problem;
  double frequency;  // of the motion
  ChebyshevPlane::Domain domain;
  std::optional<transform::StartState> start;
};

// Hazard and mean time from the point; 0 without a point.
using PassageValues = Eigen::Vector2d;

std::string unsupported_reason(const problem::Problem& problem, double barrier) {
  if (problem.noise.is_present()) {
    return "the motion between impulses is deterministic only without noise";
  }
  if (problem.impulse_factor) return "the renewal equation needs impulses without a factor";
  if (!problem.impulses.law().atoms().empty()) {
    return "means over an impulse are smooth functions only for a law with a density";
  }
  if (!problem.system.has_polynomial_force()) {
    return "the Taylor series of the motion need a polynomial force";
  }
  return problem::barrier_unsupported_reason(problem, barrier);
}

PassageProblem make_passage_problem(const problem::Problem& problem, double barrier,
                                    const std::optional<transform::StartState>& start) {
  const problem::MotionScales scales = problem::scales(problem);
  const auto [lowest, highest] = amplitude_range(problem.impulses.law());
  const UnforcedMotion motion(problem.system, barrier, problem.impulses.law().deviation(), 1);
  double speed = start ? std::abs(start->ydot) : 0;
  if (motion.acceleration({barrier, 0}) < 0) {
    // The motion that grazes the barrier has passed it less than about a period earlier.
    constexpr double kPeriods = 3, kFastest = 10;
    const double grazing = motion.largest_speed_before(
        {barrier, 0}, kPeriods * 2 * std::numbers::pi / scales.frequency, kFastest * scales.v_high);
    speed = std::max(speed, grazing);
  }
  // A faster motion, which only a very large impulse makes, soon passes the barrier.
  const auto& wall = problem.system.left_wall();
  return {
      .problem = problem,
      .frequency = scales.frequency,
      .domain = {wall ? wall->position : scales.y_low, barrier, speed + std::max(-lowest, highest)},
      .start = start};
}

// Returns the plane with a number of nodes in v per deviation of the impulses.
ChebyshevPlane make_plane(const PassageProblem& passage, double density) {
  // Nodes in sqrt(barrier - y): one for each node across the velocity of a motion through the
  // domain, and kLeast for the cusp of h at rest on the wall. The mean time from rest of case 1
  // (barrier 1.5, 114.27394) differs by 6e-6 with kLeast = 2, and by 1e-6 with 4, from that with
  // kLeast = 10.
  constexpr double kLeast = 4;
  const auto& [y_low, barrier, v_max] = passage.domain;
  const double deviation = passage.problem.impulses.law().deviation();
  const double speed = passage.frequency * (barrier - y_low);
  return {passage.domain, static_cast<int>(std::ceil(density * (kLeast + speed / deviation))),
          static_cast<int>(std::ceil(density * 2 * v_max / deviation))};
}

// Computes the values on a plane; empty if the deadline passes.
// @param hazard approximate hazard; 0 if unknown
// @param refinement divides the panels of the quadrature rules
std::optional<PassageValues> solve_on_plane(const PassageProblem& passage,
                                            const ChebyshevPlane& plane, double refinement,
                                            double hazard, const base::Deadline& deadline) {
  const RenewalEquation equation(passage.problem, plane, refinement);
  const double rate = passage.problem.impulses.arrival_rate();
  const double shifted = rate - hazard;
  const auto operators = equation.operators({{rate}, {shifted}, {shifted, 1}}, deadline);
  if (operators.empty()) return std::nullopt;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(plane.size(), plane.size());
  const Eigen::VectorXd h =
      (identity - rate * operators[0].of_function).partialPivLu().solve(operators[0].of_one);
  // Inverse iteration for the eigenvalue of rate A that is nearest to 1, and its left eigenvector
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(identity - rate * operators[1].of_function);
  constexpr int kIterations = 4;
  Eigen::VectorXd right = h, left = Eigen::VectorXd::Ones(plane.size());
  double distance = 0;  // of the eigenvalue from 1
  for (int n = 0; n < kIterations; ++n) {
    const Eigen::VectorXd next = lu.solve(right);
    distance = right.squaredNorm() / right.dot(next);
    right = next.normalized();
    left = lu.transpose().solve(left).normalized();
  }
  const double slope = rate * left.dot(operators[2].of_function * right) / left.dot(right);
  PassageValues values(hazard + distance / slope, 0);
  if (passage.start) {
    const auto mean = equation.from_state({passage.start->y, passage.start->ydot}, {rate});
    values(1) = mean.of_one + rate * mean.of_function.dot(h);
  }
  return values;
}

}  // namespace

Passage solve_passage(const problem::Problem& problem, const PassageOptions& options,
                      double barrier, std::optional<transform::StartState> start) {
  const base::Stopwatch stopwatch;
  const base::Deadline deadline(options.max_seconds);
  Passage passage{.id = "characteristics"};
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const double level = transformed.frame.wall_x(barrier);
  passage.reason = unsupported_reason(transformed, level);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  start = transform::passage_start(transformed, level, start);
  const PassageProblem below = make_passage_problem(transformed, level, start);

  // With more unknowns the dense matrices would take more than 1 GB.
  constexpr Eigen::Index kMostUnknowns = 5000;
  constexpr double kLeastDensity = 1.2, kRatio = 1.25;
  // Refinement of the panels for one node per deviation; twice as many panels change the mean time
  // of case 1 by a relative 1e-8.
  constexpr double kRefinement = 0.3;
  // Nodes are added beyond the accuracy, since the errors decrease quickly.
  constexpr double kTarget = 1e-3, kOfDifference = 2;
  std::optional<PassageValues> last;
  PassageValues errors = PassageValues::Constant(HUGE_VAL);
  std::string limit;
  double seconds_of_last = 0;
  const auto error = [&] {
    return (errors.array() / last->array().abs().max(std::numeric_limits<double>::min()))
        .maxCoeff();
  };
  for (double density = kLeastDensity; !last || error() > kTarget * options.accuracy;
       density *= kRatio) {
    const ChebyshevPlane plane = make_plane(below, density);
    if (plane.size() > kMostUnknowns) {
      limit = fmt::format("more than {} nodes are needed", kMostUnknowns);
      break;
    }
    // The number of unknowns grows by kRatio^2, and the time by its square.
    const double growth = std::pow(kRatio, 4);
    const base::Stopwatch of_level;
    std::optional<PassageValues> values;
    if (deadline.has_time_for(growth * seconds_of_last)) {
      values = solve_on_plane(below, plane, kRefinement * density, last ? (*last)(0) : 0, deadline);
    }
    if (!values) {
      limit = fmt::format("the time limit of {:g} s is reached; raise --max-seconds",
                          options.max_seconds);
      break;
    }
    seconds_of_last = of_level.seconds();
    if (last) errors = kOfDifference * (*values - *last).cwiseAbs();
    last = values;
    passage.details = fmt::format("{} x {} nodes", plane.n_y(), plane.n_v());
  }
  passage.seconds = stopwatch.seconds();
  if (!errors.allFinite()) {
    passage.reason = limit;
    return passage;
  }
  passage.hazard = {(*last)(0), errors(0)};
  if (start) passage.mean_from_point = {(*last)(1), errors(1)};
  passage.status = Status::ok;
  if (!(error() <= options.accuracy)) {
    passage.status = Status::inaccurate;
    passage.reason = fmt::format("estimated relative error {:.2g}, above the accuracy {:g}; {}",
                                 error(), options.accuracy, limit);
  }
  return passage;
}

}  // namespace fpkcheck::backward
