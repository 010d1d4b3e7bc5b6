#include "fd_fpk/stationary/along_characteristics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fd_fpk/characteristics/embedded_chain.hpp"
#include "fd_fpk/characteristics/plane.hpp"
#include "fd_fpk/operator/observables.hpp"
#include "fd_fpk/operator/resolution.hpp"
#include "fd_fpk/stationary/judgement.hpp"
#include "fd_fpk/stopwatch.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Of the transport there is no order: what is observed of cell averages takes parabolas.
constexpr int kOrder = 3;
constexpr int kCharacteristicsPerCell = 8;

struct Stationary {
  Grid grid;
  StationaryMasses found;
  double rest_mass = 0;
};

Stationary stationary_in(const problem::Problem& problem, const Options& options, const Box& box,
                         const Deadline& given_up) {
  Grid grid = characteristic_grid(problem, options, box);
  StationaryMasses found = stationary_masses(problem, grid, kCharacteristicsPerCell, given_up);
  double rest_mass = 0;
  if (found.masses) {
    rest_mass = (*found.masses)(found.rest.below) + (*found.masses)(found.rest.above);
    // The oscillator at rest turns on, and hits the wall without a speed.
    found.impacts.number += rest_mass * found.rest.impact_rate / problem.impulses.arrival_rate();
  }
  return {.grid = std::move(grid), .found = std::move(found), .rest_mass = rest_mass};
}

// Masses by displacement and by speed.
struct Sums {
  Eigen::VectorXd of_y, of_speed;
};
Sums sums(const Stationary& on) {
  const int nx = on.grid.nx(), nv = on.grid.nv();
  const Eigen::Map<const Eigen::MatrixXd> masses(on.found.masses->data(), nv, nx);
  const Eigen::VectorXd of_v = masses.rowwise().sum();
  return {.of_y = masses.colwise().sum(),
          .of_speed = of_v.tail(nv / 2) + of_v.head(nv / 2).reverse()};
}

// Of a box: what leaves it stays in the cells at its end.
constexpr double kMostAtEnd = 1e-6;
double at_end(const Sums& sums) {
  return std::max(sums.of_y(sums.of_y.size() - 1), sums.of_speed(sums.of_speed.size() - 1));
}

// The first face beyond which there is no more than `negligible`; the last one where the cells at
// the end hold more.
double end_of(const Line& line, const Eigen::VectorXd& masses, double negligible) {
  double beyond = 0;
  int last = line.cells();
  while (last > 1) {
    beyond += masses(last - 1);
    if (beyond > negligible) break;
    --last;
  }
  return line.face(last);
}

// A box that holds all but a negligible part, found on wide cells; after the deadline one that
// holds all but kMostAtEnd, without which there would be no answer.
Box box_of(const problem::Problem& problem, const Options& options, const Deadline& deadline,
           Answer so_far) {
  constexpr double kCoarse = 0.4, kNegligible = 1e-10, kWider = 1.5;
  constexpr double kSlower = 1.5;  // the wider box, about
  constexpr int kMostTimes = 6;
  Box box = generous_box(problem, options);
  if (options.x1_max && options.x2_max) return box;
  Options coarse = options;
  coarse.nx = coarse.nv = std::nullopt;
  coarse.refinement = kCoarse;
  for (int time = 0; time < kMostTimes; ++time) {
    const Stopwatch stopwatch;
    const Stationary on = stationary_in(problem, coarse, box, giving_up(deadline, so_far));
    if (!on.found.masses) return box;
    const Sums masses = sums(on);
    const double y = end_of(on.grid.x1, masses.of_y, kNegligible);
    const double v = end_of(on.grid.speeds(), masses.of_speed, kNegligible);
    const bool wider_y = !options.x1_max && y >= box.x1_max;
    const bool wider_v = !options.x2_max && v >= box.x2_max;
    const bool will_do = at_end(masses) <= kMostAtEnd;
    if (will_do && (wider_y || wider_v) && !deadline.allows(kSlower * stopwatch.seconds())) break;
    if (!options.x1_max) box.x1_max = wider_y ? kWider * box.x1_max : y;
    if (!options.x2_max) box.x2_max = wider_v ? kWider * box.x2_max : v;
    if (!wider_y && !wider_v) break;
  }
  return box;
}

void observe(const problem::Problem& problem, const Stationary& on, const Eigen::VectorXd& averages,
             Result& result) {
  auto& [solution, summary] = result;
  const double rate = problem.impulses.arrival_rate();
  const ImpactSums& impacts = on.found.impacts;
  solution.density = grid_density(on.grid, averages);
  solution.moments = moments(on.grid, averages, kOrder);
  solution.mass = on.grid.areas().dot(averages);
  solution.min_density = averages.minCoeff() / averages.maxCoeff();
  summary.wall = relative_wall_density(problem, on.grid, averages);
  summary.impact_rate = rate * impacts.number;
  solution.energy_residual =
      problem::energy_residual(problem, problem::Impact::map,
                               {.mean_velocity = solution.moments.v1,
                                .mean_square_velocity = solution.moments.v2,
                                .impact_energy_flux = rate * impacts.energy});
  summary.balances = balance_residuals(problem, on.grid, averages, kOrder, rate * impacts.momentum);
}

}  // namespace

Result solve_along_characteristics(const problem::Problem& problem, const Options& options,
                                   const Deadline& deadline, Answer so_far) {
  Result result;
  auto& [solution, summary] = result;
  const Box box = box_of(problem, options, deadline, so_far);
  const Stopwatch stopwatch;
  const Stationary on = stationary_in(problem, options, box, giving_up(deadline, so_far));
  summary.nx = on.grid.nx();
  summary.nv = on.grid.nv();
  summary.x1_max = on.grid.x1_max();
  summary.x2_max = on.grid.x2_max();
  summary.refinement = options.refinement;
  summary.transport = Transport::characteristics;
  summary.visits = on.found.visits;
  summary.krylov_iterations = on.found.iterations;
  summary.krylov_seconds = stopwatch.seconds();
  if (!on.found.masses) {
    solution.status = Status::failed;
    solution.reason = on.found.failure;
    return result;
  }
  const double frequency = std::sqrt(problem::equivalent_linearisation(problem).stiffness);
  summary.residual = on.found.residual * problem.impulses.arrival_rate() / frequency;
  summary.rest_mass = on.rest_mass;
  observe(problem, on, on.found.masses->cwiseQuotient(on.grid.areas()), result);
  solution.status = Status::ok;
  if (const double beyond = at_end(sums(on)); beyond > kMostAtEnd) {
    solution.status = Status::failed;
    solution.reason = fmt::format(
        "the box y <= {:.3g}, |y'| <= {:.3g} is too small: {:.1e} of the probability is in the cells "
        "at its end (widen it with y-max and v-max)",
        on.grid.x1_max(), on.grid.x2_max(), beyond);
    return result;
  }
  judge_resolution(options, result);
  return result;
}

}  // namespace fpkcheck::fd_fpk
