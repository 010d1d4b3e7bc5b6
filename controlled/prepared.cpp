#include "controlled/prepared.hpp"

#include <algorithm>
#include <cmath>

#include "dual/control/control_functions.hpp"
#include "dual/control/impulse_means.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::controlled {
namespace {

constexpr double kYExtent = 9, kVExtent = 10.5;  // deviations
constexpr double kYEven = 5, kVEven = 6;         // cells of one width
constexpr int kWallKnots = 3;                    // at v = 0, where grazing impacts leave a corner
constexpr double kYBin = 0.15, kVBin = 0.3, kBinExtent = 7;
constexpr double kPerDeviation = 8;  // points of the lattice
constexpr double kBeyondBox = 4;     // deviations of the impulses that the lattice goes on
constexpr double kTemperature = 2;   // of the weight, in variances of y'
constexpr double kLeastWeight = 1e-9;

std::vector<double> lattice(const mcs::DepositGrid& grid) {
  std::vector<double> v;
  for (int q = 0; q < grid.lattice_points; ++q) {
    v.push_back(grid.lattice_begin + q * grid.lattice_spacing);
  }
  return v;
}

}  // namespace

Places places(const problem::Problem& problem, const Cells& cells) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double deflection = problem::static_deflection(problem), end = kVExtent * s2;
  Places p{
      .y = dual::KnotSplines(
          dual::widening_knots(0, deflection + kYExtent * s1, deflection + kYEven * s1, cells.y)),
      .v = dual::KnotSplines(dual::widening_knots(-end, end, kVEven * s2, cells.v, kWallKnots)),
      .grid = {},
      .functionals = {}};
  const double y_bin = kYBin * s1, v_bin = kVBin * s2;
  // The outermost reach no further than the extent.
  constexpr int kReach = 2;
  const int v_half = static_cast<int>(kBinExtent / kVBin) - kReach;
  p.functionals.y_bins = {.first = -y_bin,
                          .spacing = y_bin,
                          .count = static_cast<int>((deflection + kBinExtent * s1) / y_bin),
                          .from = 0};
  p.functionals.v_bins = {.first = -v_half * v_bin, .spacing = v_bin, .count = 2 * v_half + 1};
  const double s = problem.impulses.law().deviation(), spacing = s / kPerDeviation;
  const int half = static_cast<int>(std::ceil((end + kBeyondBox * s) / spacing));
  p.grid = {.y_knots = p.y.knots(),
            .v_knots = p.v.knots(),
            .lattice_begin = -half * spacing,
            .lattice_spacing = spacing,
            .lattice_points = 2 * half + 1,
            .y_bins = p.functionals.y_bins,
            .v_bins = p.functionals.v_bins};
  for (const auto& [amplitude, probability] : problem.impulses.law().atoms()) {
    p.grid.shifts.push_back({amplitude, probability});
  }
  return p;
}

Prepared prepare(const problem::Problem& problem, const Places& places, double sampling_interval) {
  const double variance =
      std::pow(problem::equivalent_linearisation(problem).velocity_deviation, 2);
  const double temperature = kTemperature * variance;
  const double push = std::max(0.0, problem.impulses.rate_moment(1));
  const auto& potential = problem.system.potential();
  const auto work = [&](double y) { return potential(y) - push * y; };
  const double least = work(problem::static_deflection(problem));
  const dual::ControlProblem control{
      .problem = problem,
      .y = places.y,
      .v = places.v,
      .weight_y =
          [&](double y) {
            return std::max(std::exp(-(work(y) - least) / temperature), kLeastWeight);
          },
      .weight_v =
          [&](double v) { return std::max(std::exp(-v * v / (2 * temperature)), kLeastWeight); },
      .wall_weight = 1 / sampling_interval};
  auto functions = dual::control_functions(control, places.functionals.functions());
  return {
      .problem = problem,
      .places = places,
      .control = std::move(functions.coefficients),
      .after_impulse = dual::impulse_means(places.v, problem.impulses.law(), lattice(places.grid)),
      .backward_means = std::move(functions.means)};
}

}  // namespace fpkcheck::controlled
