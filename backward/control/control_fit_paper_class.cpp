#include "backward/control/control_fit_paper_class.hpp"

#include <algorithm>
#include <cmath>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::backward {
namespace {

constexpr double kYExtent = 9, kVExtent = 10.5;  // ends of the box, in deviations
constexpr double kYUniform = 5, kVUniform = 6;   // ends of the uniform cells, in deviations
constexpr int kKnotsAtZero = 3;                  // multiplicity of the knot at v = 0
constexpr double kTemperature = 2;               // temperature of the weight, in variances of y'
constexpr double kLeastWeight = 1e-9;

constexpr double kVelocityBeforeImpulse =
    2;                                 // velocity before the largest impulse, in deviations of y'
constexpr double kRareDensity = 1e-9;  // threshold of the density of the law times its deviation

/// Largest amplitude of an impulse that is not rare.
double largest_amplitude(const problem::ImpulseLaw& law) {
  constexpr int kSteps = 200;
  double largest = 0;
  for (const auto& atom : law.atoms()) largest = std::max(largest, std::abs(atom.amplitude));
  const auto pieces = law.density_breakpoints();
  for (const double end :
       {pieces.empty() ? 0 : pieces.front(), pieces.empty() ? 0 : pieces.back()}) {
    for (int k = 1; k <= kSteps; ++k) {
      const double at = end * k / kSteps;
      if (law.density(at) * law.deviation() > kRareDensity)
        largest = std::max(largest, std::abs(at));
    }
  }
  return largest;
}

/// Factor by which the box is wider than for a nearly Gaussian density. A single impulse moves the
/// oscillator beyond the narrower box if impulses are rare or their law has heavy tails.
double box_widening(const problem::Problem& problem, double velocity_deviation) {
  const double after_impulse =
      kVelocityBeforeImpulse * velocity_deviation + largest_amplitude(problem.impulses.law());
  return std::max(1.0, after_impulse / (kVExtent * velocity_deviation));
}

}  // namespace

ControlSplines control_splines_paper_class(const problem::Problem& problem,
                                           const ControlCells& cells, int graded_cells) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double deflection = problem::static_deflection(problem), wider = box_widening(problem, s2);
  const double end = wider * kVExtent * s2;
  return {.y = numerics::QuinticBSplines(
              numerics::graded_knots(0, deflection + wider * kYExtent * s1,
                                     deflection + kYUniform * s1, cells.y, 1, graded_cells)),
          .v = numerics::QuinticBSplines(numerics::graded_knots(-end, end, kVUniform * s2, cells.v,
                                                                kKnotsAtZero, graded_cells))};
}

ControlFitProblem control_fit_paper_class(const problem::Problem& problem,
                                          const numerics::QuinticBSplines& y,
                                          const numerics::QuinticBSplines& v, double wall_weight) {
  const double deviation = problem::equivalent_linearisation(problem).velocity_deviation;
  const double temperature =
      kTemperature * std::pow(box_widening(problem, deviation) * deviation, 2);
  const double push = std::max(0.0, problem.impulses.rate_times_moment(1));
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

}  // namespace fpkcheck::backward
