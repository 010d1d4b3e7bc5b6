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
  double frequency;  // of the motion
  ChebyshevPlane::Domain domain;
  std::optional<transform::StartState> start;
};

// Values on a plane; the mean time from the point is 0 without a point.
using PassageValues = Eigen::Vector2d;
enum PassageValue { kHazard, kMeanFromPoint };

std::string unsupported_reason(const problem::Problem& problem, double barrier) {
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

// Returns the problem on a domain that contains the motions to the barrier and from the start. The
// largest impulse widens the domain.
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
  const auto [most_negative, most_positive] = amplitude_range(problem.impulses.amplitude_law());
  const UnforcedMotion motion(problem.system, barrier, problem.impulses.amplitude_law().deviation(),
                              1);
  if (motion.acceleration({barrier, 0}) < 0) {
    // Traced back, the grazing motion reaches the barrier within about one period.
    constexpr double kPeriods = 3, kFastest = 10;
    const double fastest = kFastest * std::max(scales.v_high, speed);
    speed = std::max(
        speed, std::min(fastest, motion.largest_speed_before(
                                     {barrier, 0},
                                     kPeriods * 2 * std::numbers::pi / scales.frequency, fastest)));
  }
  return {.problem = problem,
          .frequency = scales.frequency,
          .domain = {y_low, barrier, speed + std::max(-most_negative, most_positive)},
          .start = start};
}

// Returns the numbers of nodes in y and in v for a number of nodes in v per deviation of the
// impulses. In sqrt(barrier - y) there are kLeast nodes, for the cusp of h at rest on the wall, and
// as many as in v for the speed of a motion through the domain. The mean time from rest of case 1
// (barrier 1.5, 114.27394) differs by 6e-6 with kLeast = 2, and by 1e-6 with 4, from that with
// kLeast = 10.
std::array<double, 2> node_counts(const PassageProblem& passage, double nodes_per_deviation) {
  constexpr double kLeast = 4;
  const auto& [y_low, barrier, v_max] = passage.domain;
  const double deviation = passage.problem.impulses.amplitude_law().deviation();
  const double speed = passage.frequency * (barrier - y_low);
  return {std::ceil(nodes_per_deviation * (kLeast + speed / deviation)),
          std::ceil(nodes_per_deviation * 2 * v_max / deviation)};
}

// Computes the values on a plane; empty if the deadline passes.
// @param hazard approximate hazard; 0 if unknown
// @param refinement divides the panels of the quadrature rules
std::optional<PassageValues> solve_on_plane(const PassageProblem& passage,
                                            const ChebyshevPlane& plane, double refinement,
                                            double hazard, const base::Deadline& deadline) {
  const double rate = passage.problem.impulses.arrival_rate();
  const double shifted = rate - hazard;
  const RenewalEquation equation(passage.problem, plane, shifted, refinement);
  auto operators = equation.operators({{rate}, {shifted}, {shifted, 1}}, deadline);
  if (operators.empty()) return std::nullopt;
  const auto factorise = [&](Eigen::MatrixXd& matrix) {
    matrix *= -rate;
    matrix.diagonal().array() += 1;
    return Eigen::PartialPivLU<Eigen::MatrixXd>(matrix);
  };
  const Eigen::VectorXd h = factorise(operators[0].of_function).solve(operators[0].of_one);
  // Inverse iteration for the eigenvalue of rate A that is nearest to 1, and its eigenvectors
  const auto lu = factorise(operators[1].of_function);
  constexpr int kIterations = 8;
  Eigen::VectorXd right = h, left = Eigen::VectorXd::Ones(plane.size());
  double distance = 0;  // of the eigenvalue from 1
  for (int n = 0; n < kIterations; ++n) {
    const Eigen::VectorXd next = lu.solve(right);
    distance = left.dot(right) / left.dot(next);
    right = next.normalized();
    left = lu.transpose().solve(left).normalized();
  }
  const double slope = rate * left.dot(operators[2].of_function * right) / left.dot(right);
  PassageValues values = PassageValues::Zero();
  values(kHazard) = hazard + distance / slope;
  if (passage.start) {
    const auto mean = equation.from_state({passage.start->y, passage.start->ydot}, {rate});
    values(kMeanFromPoint) = mean.of_one + rate * mean.of_function.dot(h);
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
  const double wall_barrier = transformed.frame.wall_x(barrier);
  passage.reason = unsupported_reason(transformed, wall_barrier);
  if (!passage.reason.empty()) {
    passage.status = Status::not_offered;
    return passage;
  }
  start = transform::passage_start(transformed, wall_barrier, start);
  const PassageProblem below = make_passage_problem(transformed, wall_barrier, start);

  // The dense matrices of this number of unknowns take about 1 GB.
  constexpr double kMostUnknowns = 5000;
  constexpr double kLeastNodes = 0.96, kRatio = 1.25;  // nodes per deviation
  // Refinement of the panels for one node per deviation; twice as many panels change the mean time
  // of case 1 by a relative 1e-8.
  constexpr double kRefinement = 0.3;
  // Nodes are added beyond the accuracy, since the errors decrease quickly. The error is 1 /
  // (kRatio - 1) differences for convergence of first order, as under laws whose density jumps.
  constexpr double kTargetFraction = 1e-3, kErrorFactor = 1 / (kRatio - 1);
  std::optional<PassageValues> last;
  PassageValues errors = PassageValues::Constant(HUGE_VAL);
  std::string limit;
  double seconds_of_last_plane = 0;
  const double rate = transformed.impulses.arrival_rate();
  double hazard = 0;
  const auto error = [&] {
    return (errors.array() / last->array().abs().max(std::numeric_limits<double>::min()))
        .maxCoeff();
  };
  for (double nodes = kLeastNodes; !last || error() > kTargetFraction * options.accuracy;
       nodes *= kRatio) {
    const auto [n_y, n_v] = node_counts(below, nodes);
    if (n_y * n_v > kMostUnknowns) {
      limit = fmt::format("more than {} nodes are needed", kMostUnknowns);
      break;
    }
    const ChebyshevPlane plane(below.domain, static_cast<int>(n_y), static_cast<int>(n_v));
    // The number of unknowns grows by kRatio^2, and the time of all integrals along motions by
    // kRatio^5.
    const double growth = std::pow(kRatio, 5);
    const base::Stopwatch of_plane;
    std::optional<PassageValues> values;
    if (deadline.has_time_for(growth * seconds_of_last_plane)) {
      values = solve_on_plane(below, plane, kRefinement * nodes, hazard, deadline);
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
    seconds_of_last_plane = of_plane.seconds();
    if (last) errors = kErrorFactor * (*values - *last).cwiseAbs();
    last = values;
    // The next plane continues Newton's method for the hazard. The limit (hazard + rate) / 2
    // shortens a step that would exceed the rate.
    hazard = std::clamp((*values)(kHazard), 0.0, (hazard + rate) / 2);
    passage.details = fmt::format("{} x {} nodes", plane.n_y(), plane.n_v());
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
