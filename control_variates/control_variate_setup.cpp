#include "control_variates/control_variate_setup.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "backward/control_variates/control_variate_fit.hpp"
#include "backward/control_variates/control_variate_functions.hpp"
#include "backward/control_variates/generator_factors.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::control_variates {
namespace {

// Spacings and extent of the smooth bins, in standard deviations of y and of y'
constexpr double kYBinSpacing = 0.15, kVBinSpacing = 0.3, kBinExtent = 7;
constexpr double kLatticePointsPerDeviation = 8;
// Length of the velocity lattice beyond the splines, in standard deviations of the impulses.
constexpr double kLatticeExtension = 4;

std::vector<double> lattice_velocities(const mcs::SampleDepositionGrid& grid) {
  std::vector<double> v;
  for (int q = 0; q < grid.lattice_points; ++q) {
    v.push_back(grid.lattice_begin + q * grid.lattice_spacing);
  }
  return v;
}

double constant_one(double) { return 1; }

std::function<double(double)> power_function(int n) {
  return [n](double x) { return std::pow(x, n); };
}

std::function<double(double)> smooth_bin_function(const transform::SmoothBins& bins, int b) {
  return [bins, b](double x) {
    return transform::cardinal_cubic_spline((x - bins.first) / bins.spacing - b);
  };
}

}  // namespace

std::vector<backward::SeparableFunction> EstimatedFunctionals::integrands_of_functionals() const {
  std::vector<backward::SeparableFunction> all;
  for (const auto& [p, q] : kMoments) all.push_back({power_function(p), power_function(q)});
  for (int b = 0; b < y_bins.count; ++b)
    all.push_back({smooth_bin_function(y_bins, b), constant_one});
  for (int b = 0; b < v_bins.count; ++b)
    all.push_back({constant_one, smooth_bin_function(v_bins, b)});
  return all;
}

std::vector<double> EstimatedFunctionals::functional_means_in_stream(
    const mcs::DepositedSumsOfTrajectory& stream) const {
  std::vector<double> all;
  for (const auto& [p, q] : kMoments) {
    const auto at = std::ranges::find(mcs::kRecordedMomentPowers, std::pair{p, q}) -
                    mcs::kRecordedMomentPowers.begin();
    all.push_back(stream.powers[static_cast<std::size_t>(at)] / stream.samples);
  }
  const auto put = [&](const std::vector<double>& sums, int count) {
    for (int b = 0; b < count; ++b) {
      all.push_back(sums[static_cast<std::size_t>(b + mcs::DepositedSampleSums::kBinOffset)] /
                    stream.samples);
    }
  };
  put(stream.sums.y_bins, y_bins.count);
  put(stream.sums.v_bins, v_bins.count);
  return all;
}

DepositionSplineLayout make_deposition_spline_layout(const problem::Problem& problem,
                                                     const ControlVariateSplineCellCounts& cells) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double s1 = linear.displacement_deviation, s2 = linear.velocity_deviation;
  const double deflection = problem::static_deflection(problem);
  auto splines = backward::make_control_splines(problem, {.y_cells = cells.y, .v_cells = cells.v},
                                                backward::SplineCellWidthDistribution::equal);
  DepositionSplineLayout p{.y = std::move(splines.y_splines),
                           .v = std::move(splines.v_splines),
                           .grid = {},
                           .functionals = {}};
  const double y_bin = kYBinSpacing * s1, v_bin = kVBinSpacing * s2;
  constexpr int kBinHalfWidth = 2;
  const int v_half = static_cast<int>(kBinExtent / kVBinSpacing) - kBinHalfWidth;
  p.functionals.y_bins = {.first = -y_bin,
                          .spacing = y_bin,
                          .count = static_cast<int>((deflection + kBinExtent * s1) / y_bin),
                          .from = 0};
  p.functionals.v_bins = {.first = -v_half * v_bin, .spacing = v_bin, .count = 2 * v_half + 1};
  const double s = problem.impulses.amplitude_law().amplitude_standard_deviation(),
               spacing = s / kLatticePointsPerDeviation;
  const int half = static_cast<int>(std::ceil((p.v.end() + kLatticeExtension * s) / spacing));
  p.grid = {.y_knots = p.y.knots(),
            .v_knots = p.v.knots(),
            .lattice_begin = -half * spacing,
            .lattice_spacing = spacing,
            .lattice_points = 2 * half + 1,
            .y_bins = p.functionals.y_bins,
            .v_bins = p.functionals.v_bins};
  for (const auto& [amplitude, probability] : problem.impulses.amplitude_law().amplitude_atoms()) {
    p.grid.velocity_jumps.push_back({amplitude, probability});
  }
  // For discrete impulse laws the sums are in `velocity_jumps` instead of a velocity lattice.
  if (!p.grid.velocity_jumps.empty()) p.grid.lattice_points = mcs::SampleDepositionGrid::kStencil;
  return p;
}

ControlVariateSetup make_control_variate_setup(const problem::Problem& problem,
                                               const DepositionSplineLayout& deposit_layout,
                                               double sampling_interval) {
  const auto control = backward::make_control_fit_problem(problem, deposit_layout.y,
                                                          deposit_layout.v, 1 / sampling_interval);
  auto functions = backward::fit_control_variate_functions(
      control, deposit_layout.functionals.integrands_of_functionals());
  return {.problem = problem,
          .deposit_layout = deposit_layout,
          .control = std::move(functions.spline_coefficients),
          .after_impulse = backward::spline_means_after_impulse(
              deposit_layout.v, problem.impulses.amplitude_law(),
              lattice_velocities(deposit_layout.grid)),
          .backward_means = std::move(functions.mean_estimates)};
}

}  // namespace fpkcheck::control_variates
