#include "dual/control/usual_control.hpp"

#include <algorithm>
#include <cmath>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::dual {
namespace {

constexpr double kYExtent = 9, kVExtent = 10.5;  // deviations
constexpr double kYEven = 5, kVEven = 6;         // cells of one width
constexpr int kWallKnots = 3;                    // at v = 0
constexpr double kTemperature = 2;               // of the weight, in variances of y'
constexpr double kLeastWeight = 1e-9;

}  // namespace

ControlSplines usual_splines(const problem::Problem& problem, const ControlCells& cells) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double deflection = problem::static_deflection(problem), end = kVExtent * s2;
  return {.y = KnotSplines(
              widening_knots(0, deflection + kYExtent * s1, deflection + kYEven * s1, cells.y)),
          .v = KnotSplines(widening_knots(-end, end, kVEven * s2, cells.v, kWallKnots))};
}

ControlProblem usual_control(const problem::Problem& problem, const KnotSplines& y,
                             const KnotSplines& v, double wall_weight) {
  const double variance =
      std::pow(problem::equivalent_linearisation(problem).velocity_deviation, 2);
  const double temperature = kTemperature * variance;
  const double push = std::max(0.0, problem.impulses.rate_moment(1));
  const auto work = [potential = problem.system.potential(), push](double at) {
    return potential(at) - push * at;
  };
  const double least = work(problem::static_deflection(problem));
  return {
      .problem = problem,
      .y = y,
      .v = v,
      .weight_y =
          [=](double at) {
            return std::max(std::exp(-(work(at) - least) / temperature), kLeastWeight);
          },
      .weight_v =
          [=](double at) { return std::max(std::exp(-at * at / (2 * temperature)), kLeastWeight); },
      .wall_weight = wall_weight};
}

}  // namespace fpkcheck::dual
