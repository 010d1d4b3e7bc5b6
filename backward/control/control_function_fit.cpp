#include "backward/control/control_function_fit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "backward/control/generator_factors.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::backward {
namespace {

constexpr double kBoxFactorY = 9.0 / 7,
                 kBoxFactorV = 1.5;  // size of the box in units of the extents of MotionScales
constexpr double kUniformFraction = 0.55;  // fraction of the extent that has uniform cells
constexpr double kMinCellRatio = 0.05;     // width of the narrowest cell relative to a uniform cell
// Width ratio of the narrowest cell of y if white noise and impact losses cause a spike at the
// wall, with a width of v^3 / D
constexpr double kMinSpikeCellRatio = 0.002;
constexpr double kCellGrowth =
    0.25;                        // increase of the cell width per distance from the narrowest cell
constexpr int kCornerKnots = 3;  // multiplicity of the knot at v = 0 with a wall
constexpr double kWeightTemperature = 2;  // temperature T of the weight, in variances of y'
// Temperature T of the weight with several wells. The slowest solution of the backward equation is
// nearly constant in each well and varies at the barrier between wells. The magnitude of the
// slowest solution is the exchange time between the wells, exp(barrier / T). With a weight wider
// than the density, the residual on the barrier adds more to the weighted sum than wrong means in
// the wells. The fit then omits the slowest solution. Of 30 random problems the fit contains the
// slowest solution in 14 at temperature 2 and in 18 at temperature 0.7 (RandomWells in
// tests/backward/residual). In ten of the 30 problems the unresolved residual is nearly constant
// for temperatures 0.5 to 0.7, and larger at temperatures 1 and 2.
constexpr double kWellWeightTemperature = 0.7;
constexpr double kNegligibleRatio = 1e-9;

// Cells for a nearly Gaussian density, as fractions of the extents of MotionScales, which are seven
// deviations. Cells have equal width up to these fractions, and geometrically increasing widths
// outside. With cells from cell_widths() the standard errors of E[y^2], E[y'] and p(y) were larger
// than with geometric cells (`ctest -R baselines.case2`).
constexpr double kGaussianCoreY = 5.0 / 7, kGaussianCoreV = 6.0 / 7;
// The same for CellWidths::even. Where only few samples fall, h may be inaccurate: with 64 x 100
// cells the L1 error of p(y) in case 1 is half of that with the cores above.
constexpr double kEvenCore = 4.0 / 7;
// number of cells of decreasing width towards the wall and towards v = 0
constexpr int kGradedCells = 12;
constexpr double kOffWallDeflection = 4;  // static deflection off the wall, in deviations of y

/// Returns break points from `begin` to `end` such that the cell width is proportional to `width`.
std::vector<double> breaks_by_width(double begin, double end, int cells,
                                    const std::function<double(double)>& width) {
  constexpr int kSteps = 4000;
  std::vector<double> cumulative_cells{0};
  const double step = (end - begin) / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    cumulative_cells.push_back(cumulative_cells.back() + step / width(begin + (k + 0.5) * step));
  }
  std::vector<double> breaks{begin};
  std::size_t at = 0;
  for (int n = 1; n < cells; ++n) {
    const double target = cumulative_cells.back() * n / cells;
    while (cumulative_cells[at + 1] < target) ++at;
    const double fraction =
        (target - cumulative_cells[at]) / (cumulative_cells[at + 1] - cumulative_cells[at]);
    breaks.push_back(begin + step * (static_cast<double>(at) + fraction));
  }
  breaks.push_back(end);
  return breaks;
}

/// Returns the cell width as a function of position. The width is `even` between `low` and `high`,
/// increases outside the interval [low, high], and decreases towards the points `narrow_at`.
std::function<double(double)> cell_widths(std::vector<double> narrow_at, double even, double low,
                                          double high, double least_cell = kMinCellRatio) {
  return [=](double x) {
    const double outside = std::max({0.0, low - x, x - high});
    double width = even + kCellGrowth * outside;
    for (const double place : narrow_at) {
      width = std::min(width, even * least_cell + kCellGrowth * std::abs(x - place));
    }
    return width;
  };
}

/// Returns the largest impulse amplitude at which the density times the deviation of the law
/// exceeds 1e-9.
double largest_amplitude(const problem::ImpulseTrain& impulses) {
  if (!impulses.is_present()) return 0;
  double largest = 0;
  for (const auto& atom : impulses.amplitude_law().atoms()) {
    largest = std::max(largest, std::abs(atom.amplitude));
  }
  constexpr int kSteps = 200;
  const auto pieces = impulses.amplitude_law().density_breakpoints();
  if (pieces.empty()) return largest;
  for (const double end : {pieces.front(), pieces.back()}) {
    for (int k = 1; k <= kSteps; ++k) {
      const double at = end * k / kSteps;
      if (impulses.amplitude_law().density(at) * impulses.amplitude_law().deviation() >
          kNegligibleRatio) {
        largest = std::max(largest, std::abs(at));
      }
    }
  }
  return largest;
}

/// Returns a factor >= 1 by which the box is widened to contain the velocity after the largest
/// impulse.
double box_widening(const problem::Problem& problem, const problem::MotionScales& scales) {
  constexpr double kInitialVelocity =
      2;  // velocity before the largest impulse, in deviations of y'
  const double after =
      kInitialVelocity * scales.velocity_deviation + largest_amplitude(problem.impulses);
  return std::max(1.0, after / (kBoxFactorV * scales.v_high));
}

}  // namespace

ControlSplines control_splines(const problem::Problem& problem, const ControlCells& cells,
                               CellWidths widths) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::System& system = problem.system;
  const double wider = box_widening(problem, scales);
  const double low = scales.centre - scales.y_low, high = scales.y_high - scales.centre;
  double begin = scales.centre - wider * kBoxFactorY * low;
  double end = scales.centre + wider * kBoxFactorY * high;
  std::vector<double> narrow_at;
  int y_cells = 2 * cells.y;
  if (system.left_wall() && system.left_wall()->position > begin) {
    begin = system.left_wall()->position;
    narrow_at.push_back(begin);
    y_cells = cells.y;
  }
  if (system.right_wall() && system.right_wall()->position < end) {
    end = system.right_wall()->position;
    narrow_at.push_back(end);
  }
  const double v_end = wider * kBoxFactorV * scales.v_high;
  if (problem::has_equivalent_linearisation(problem)) {
    const bool off_wall = scales.centre > kOffWallDeflection * scales.displacement_deviation;
    const bool even = widths == CellWidths::even;
    const int graded = even || off_wall ? 0 : kGradedCells;
    const double core_y = even ? kEvenCore : kGaussianCoreY;
    const double core_v = even ? kEvenCore : kGaussianCoreV;
    return {.y = numerics::QuinticBSplines(numerics::graded_knots(
                begin, end, scales.centre + core_y * high, cells.y, 1, graded)),
            .v = numerics::QuinticBSplines(numerics::graded_knots(
                -v_end, v_end, core_v * scales.v_high, cells.v, kCornerKnots, graded))};
  }
  assert(widths == CellWidths::narrower_at_walls);
  const double even_y = (high + low) / cells.y, even_v = 2 * scales.v_high / cells.v;
  const bool spike = problem.noise.is_present() &&
                     std::ranges::any_of(impact_walls(system),
                                         [](const auto& wall) { return wall.restitution < 1; });
  const auto y_width = cell_widths(
      narrow_at, even_y, scales.centre - wider * kUniformFraction * low,
      scales.centre + wider * kUniformFraction * high, spike ? kMinSpikeCellRatio : kMinCellRatio);
  const double even_to = wider * kUniformFraction * scales.v_high;
  const bool walls = !narrow_at.empty();
  const auto v_width = cell_widths(walls ? std::vector<double>{0} : std::vector<double>{}, even_v,
                                   -even_to, even_to);
  std::vector<double> side = breaks_by_width(0, v_end, cells.v / 2, v_width), v_breaks;
  for (auto at = side.rbegin(); at != side.rend(); ++at) v_breaks.push_back(-*at);
  v_breaks.back() = 0;
  v_breaks.insert(v_breaks.end(), side.begin() + 1, side.end());
  return {.y = numerics::QuinticBSplines(
              numerics::knots_from_breaks(breaks_by_width(begin, end, y_cells, y_width))),
          .v = numerics::QuinticBSplines(
              numerics::knots_from_breaks(v_breaks, walls ? kCornerKnots : 1))};
}

ControlFitProblem control_function_fit(const problem::Problem& problem,
                                       const numerics::QuinticBSplines& y,
                                       const numerics::QuinticBSplines& v, double wall_weight) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const double temperature_factor =
      problem::problem_features(problem).wells > 1 ? kWellWeightTemperature : kWeightTemperature;
  const double temperature =
      temperature_factor * std::pow(box_widening(problem, scales) * scales.velocity_deviation, 2);
  const numerics::Polynomial potential = problem::effective_potential_polynomial(problem);
  double least = std::numeric_limits<double>::infinity();
  for (const double at : y.breaks()) least = std::min(least, potential(at));
  return {.problem = problem,
          .y = y,
          .v = v,
          .weight_y =
              [=](double at) {
                return std::clamp(std::exp(-(potential(at) - least) / temperature),
                                  kNegligibleRatio, 1.0);
              },
          .weight_v =
              [=](double at) {
                return std::max(std::exp(-at * at / (2 * temperature)), kNegligibleRatio);
              },
          .wall_weight = wall_weight};
}

}  // namespace fpkcheck::backward
