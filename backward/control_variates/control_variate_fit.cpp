#include "backward/control_variates/control_variate_fit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "backward/control_variates/generator_factors.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::backward {
namespace {

// Extents of the splines in y and v, in units of the ranges of the motion in MotionScales
constexpr double kBoxFactorY = 9.0 / 7, kBoxFactorV = 1.5;
constexpr double kUniformFraction = 0.55;  // fraction of the extent that has uniform cells
constexpr double kMinCellRatio = 0.05;     // width of the narrowest cell relative to a uniform cell
// Width of the narrowest cell of y relative to a uniform cell, if white noise D and impact losses
// cause a narrow peak of the density at the wall, with a width of v^3 / D
constexpr double kMinSpikeCellRatio = 0.002;
constexpr double kCellGrowth = 0.25;  // increase of the cell width per distance from a narrow cell
constexpr int kCornerKnots = 3;       // multiplicity of the knot at v = 0 with a wall
constexpr double kWeightTemperature = 2;  // temperature T of the weight, in variances of v
// Temperature T of the fit weight exp(-energy/T) for potentials with several wells, in variances of
// v. The slowest mode of the backward equation is nearly constant in each potential well and varies
// at the barrier between wells. The magnitude of the slowest mode in a backward solution is the
// transition time between the wells, of the order exp(barrier / T). If the weight decreases more
// slowly than the density, the residual on the barrier adds more to the weighted sum of squares
// than wrong means in the wells. The fit then omits the slowest mode. Of 30 random problems with
// wells the fit contains the slowest mode in 14 at temperature 2 and in 18 at temperature 0.7
// (RandomWells in tests/backward/residual). In ten of the 30 random problems with wells the
// residual is nearly constant for temperatures 0.5 to 0.7, and larger at temperatures 1 and 2.
constexpr double kWellWeightTemperature = 0.7;
constexpr double kNegligibleRatio = 1e-9;  // value relative to a maximum that is negligible

// Ends of the spline cells of equal width for a nearly Gaussian density, as fractions of the
// extents of MotionScales, which are seven standard deviations. Outside the cells of equal width
// the widths of the spline cells increase geometrically. With other cells (cell_width_function())
// the standard errors of E[y^2], E[y'] and p(y) were larger than with cells of geometrically
// increasing width (`ctest -R baselines.case2`).
constexpr double kGaussianUniformFractionY = 5.0 / 7, kGaussianUniformFractionV = 6.0 / 7;
// Ends of the spline cells of equal width for SplineCellWidthDistribution::equal, as fractions of
// the extents of the motion. The control function h may be inaccurate where the simulation has few
// samples. With 64 x 100 spline cells these fractions halve the L1 error of p(y) in case 1,
// compared with the fractions for a nearly Gaussian density.
constexpr double kSimulationUniformFraction = 4.0 / 7;
// Number of spline cells of decreasing width towards the wall and towards v = 0
constexpr int kGradedCells = 12;
// Static deflection, in standard deviations of y, above which the motion does not reach the wall
constexpr double kOffWallDeflection = 4;

/// Returns break points of splines from `begin` to `end`. The width of a spline cell is
/// proportional to the value of the function `width` in the cell.
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

/// Returns the width of the spline cells as a function of position. The cell width is
/// `uniform_width` between `low` and `high`, increases outside of [low, high], and decreases near
/// the points `narrow_positions` to min_ratio * uniform_width.
std::function<double(double)> cell_width_function(std::vector<double> narrow_positions,
                                                  double uniform_width, double low, double high,
                                                  double min_ratio = kMinCellRatio) {
  return [=](double x) {
    const double outside = std::max({0.0, low - x, x - high});
    double width = uniform_width + kCellGrowth * outside;
    for (const double place : narrow_positions) {
      width = std::min(width, uniform_width * min_ratio + kCellGrowth * std::abs(x - place));
    }
    return width;
  };
}

/// Returns the largest magnitude of a non-negligible impulse amplitude: an atom, or an amplitude at
/// which the density times the standard deviation of the law exceeds 1e-9.
double largest_relevant_amplitude(const problem::ImpulseTrain& impulses) {
  if (!impulses.is_acting()) return 0;
  double largest = 0;
  for (const auto& atom : impulses.amplitude_law().amplitude_atoms()) {
    largest = std::max(largest, std::abs(atom.amplitude));
  }
  constexpr int kSteps = 200;
  const auto pieces = impulses.amplitude_law().amplitude_density_breakpoints();
  if (pieces.empty()) return largest;
  for (const double end : {pieces.front(), pieces.back()}) {
    for (int k = 1; k <= kSteps; ++k) {
      const double at = end * k / kSteps;
      if (impulses.amplitude_law().density(at) *
              impulses.amplitude_law().amplitude_standard_deviation() >
          kNegligibleRatio) {
        largest = std::max(largest, std::abs(at));
      }
    }
  }
  return largest;
}

/// Returns a factor >= 1 by which the ranges of y and v are widened to contain the largest impulse.
double range_widening(const problem::Problem& problem, const problem::MotionScales& scales) {
  // Velocity before the largest impulse, in standard deviations of the velocity v
  constexpr double kInitialVelocity = 2;
  const double after =
      kInitialVelocity * scales.velocity_deviation + largest_relevant_amplitude(problem.impulses);
  return std::max(1.0, after / (kBoxFactorV * scales.v_high));
}

}  // namespace

ControlVariateSplines make_control_splines(const problem::Problem& problem,
                                           const ControlVariateCellCounts& cells,
                                           SplineCellWidthDistribution widths) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const problem::System& system = problem.system;
  const double widening = range_widening(problem, scales);
  const double low = scales.centre - scales.y_low, high = scales.y_high - scales.centre;
  double begin = scales.centre - widening * kBoxFactorY * low;
  double end = scales.centre + widening * kBoxFactorY * high;
  std::vector<double> narrow_positions;
  int y_cells = 2 * cells.y_cells;
  if (system.left_wall() && system.left_wall()->position > begin) {
    begin = system.left_wall()->position;
    narrow_positions.push_back(begin);
    y_cells = cells.y_cells;
  }
  if (system.right_wall() && system.right_wall()->position < end) {
    end = system.right_wall()->position;
    narrow_positions.push_back(end);
  }
  const double v_end = widening * kBoxFactorV * scales.v_high;
  if (problem::has_equivalent_linearisation(problem)) {
    const bool off_wall = scales.centre > kOffWallDeflection * scales.displacement_deviation;
    const bool is_equal = widths == SplineCellWidthDistribution::equal;
    const int graded = is_equal || off_wall ? 0 : kGradedCells;
    const double uniform_fraction_y =
        is_equal ? kSimulationUniformFraction : kGaussianUniformFractionY;
    const double uniform_fraction_v =
        is_equal ? kSimulationUniformFraction : kGaussianUniformFractionV;
    return {.y_splines = numerics::QuinticBSplines(numerics::graded_knots(
                begin, end, scales.centre + uniform_fraction_y * high, cells.y_cells, 1, graded)),
            .v_splines = numerics::QuinticBSplines(
                numerics::graded_knots(-v_end, v_end, uniform_fraction_v * scales.v_high,
                                       cells.v_cells, kCornerKnots, graded))};
  }
  assert(widths == SplineCellWidthDistribution::narrower_at_walls);
  const double uniform_y_width = (high + low) / cells.y_cells,
               uniform_v_width = 2 * scales.v_high / cells.v_cells;
  const bool spike = problem.noise.is_acting() &&
                     std::ranges::any_of(walls_with_restitution(system),
                                         [](const auto& wall) { return wall.restitution < 1; });
  const auto y_width = cell_width_function(narrow_positions, uniform_y_width,
                                           scales.centre - widening * kUniformFraction * low,
                                           scales.centre + widening * kUniformFraction * high,
                                           spike ? kMinSpikeCellRatio : kMinCellRatio);
  const double uniform_v_end = widening * kUniformFraction * scales.v_high;
  const bool walls = !narrow_positions.empty();
  const auto v_width = cell_width_function(walls ? std::vector<double>{0} : std::vector<double>{},
                                           uniform_v_width, -uniform_v_end, uniform_v_end);
  std::vector<double> side = breaks_by_width(0, v_end, cells.v_cells / 2, v_width), v_breaks;
  for (auto at = side.rbegin(); at != side.rend(); ++at) v_breaks.push_back(-*at);
  v_breaks.back() = 0;
  v_breaks.insert(v_breaks.end(), side.begin() + 1, side.end());
  return {.y_splines = numerics::QuinticBSplines(
              numerics::knots_from_breaks(breaks_by_width(begin, end, y_cells, y_width))),
          .v_splines = numerics::QuinticBSplines(
              numerics::knots_from_breaks(v_breaks, walls ? kCornerKnots : 1))};
}

ControlVariateFitProblem make_control_fit_problem(const problem::Problem& problem,
                                                  const numerics::QuinticBSplines& y_splines,
                                                  const numerics::QuinticBSplines& v_splines,
                                                  double wall_jump_weight) {
  const problem::MotionScales scales = problem::motion_scales(problem);
  const double temperature_factor =
      problem::problem_features(problem).wells > 1 ? kWellWeightTemperature : kWeightTemperature;
  const double temperature =
      temperature_factor * std::pow(range_widening(problem, scales) * scales.velocity_deviation, 2);
  const numerics::Polynomial potential = problem::effective_potential_polynomial(problem);
  double least = std::numeric_limits<double>::infinity();
  for (const double at : y_splines.breaks()) least = std::min(least, potential(at));
  return {.problem = problem,
          .y_splines = y_splines,
          .v_splines = v_splines,
          .y_weight =
              [=](double at) {
                return std::clamp(std::exp(-(potential(at) - least) / temperature),
                                  kNegligibleRatio, 1.0);
              },
          .v_weight =
              [=](double at) {
                return std::max(std::exp(-at * at / (2 * temperature)), kNegligibleRatio);
              },
          .wall_jump_weight = wall_jump_weight};
}

}  // namespace fpkcheck::backward
