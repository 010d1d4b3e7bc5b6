#include "fd_fpk/functionals/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/grid_sequence.hpp"
#include "fd_fpk/functionals/reduced_resolvent.hpp"
#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/selection_policy.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Relative error of each spectral density at which no finer grid is tried, as a fraction of
// FiniteVolumeOptions::accuracy
constexpr double kTargetFraction = 0.2;
// Smallest spectral density to which relative errors refer, relative to the largest spectral
// density
constexpr double kFloor = 1e-3;
// Largest accepted relative difference between the spectral densities of two successive Krylov
// spaces; the error estimates contain the largest accepted difference
constexpr double kAgreement = 1e-5;

constexpr int kModes = 2;  // number of modes in the result
// Number of the values of the modes: for each mode decay rate, frequency and share
constexpr Eigen::Index kModeValues = 3 * kModes;
// Number of the values after the spectral densities and autocovariances: the variance, the values
// of the modes, and their changes by the last vectors of the Krylov space
constexpr Eigen::Index kFurtherValues = 1 + 2 * kModeValues;

// Returns decay rate, frequency and share of the variance of the modes with the largest
// coefficients, three values for each mode. A conjugate pair is one mode.
Eigen::VectorXd largest_modes(const ReducedResolvent::Modes& modes, double variance) {
  std::vector<Eigen::Index> upper;
  for (Eigen::Index j = 0; j < modes.rates.size(); ++j) {
    if (modes.rates(j).imag() >= 0) upper.push_back(j);
  }
  const auto share = [&](Eigen::Index j) {
    const int conjugates = modes.rates(j).imag() > 0 ? 2 : 1;
    return conjugates * modes.coefficients(j).real() / variance;
  };
  std::ranges::sort(upper, std::ranges::greater{}, [&](Eigen::Index j) { return share(j); });
  Eigen::VectorXd values = Eigen::VectorXd::Zero(kModeValues);
  for (int m = 0; m < std::min(kModes, static_cast<int>(upper.size())); ++m) {
    const Eigen::Index j = upper[m];
    values.segment(3 * m, 3) << -modes.rates(j).real(), modes.rates(j).imag(), share(j);
  }
  return values;
}

// Returns the autocovariance sum c exp(a t) at the lags t, over the modes that decay.
Eigen::VectorXd autocovariance_from_modes(const ReducedResolvent::Modes& modes,
                                          const std::vector<double>& lags) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(lags.size()));
  for (Eigen::Index j = 0; j < modes.rates.size(); ++j) {
    if (!(modes.rates(j).real() < 0)) continue;
    for (std::size_t k = 0; k < lags.size(); ++k) {
      values(static_cast<Eigen::Index>(k)) +=
          (modes.coefficients(j) * std::exp(modes.rates(j) * lags[k])).real();
    }
  }
  return values;
}

// Returns the densities at the frequencies, the autocovariances at the lags, the changes of the
// autocovariances by the last vectors of the Krylov space, the variance, the modes, and the changes
// of the modes. The Krylov space grows until the densities of two successive spaces agree; with few
// frequencies, autocovariances and modes may then still change.
Eigen::VectorXd spectrum_on_grid(const std::vector<double>& frequencies,
                                 const std::vector<double>& lags, transform::StateVariable variable,
                                 double shift, int order, DirectStationarySolution& direct_solution,
                                 const base::Deadline& deadline, std::string& failure) {
  constexpr int kStep = 10, kMost = 200;
  const PhasePlaneGrid& grid = direct_solution.discretisation.grid;
  const Eigen::VectorXd& p = *direct_solution.averages;
  const Eigen::VectorXd functional = coordinate_mean_functional(grid, variable, order);
  const double mean = functional.dot(p) / direct_solution.op.total_mass(p);
  const Eigen::VectorXd b = multiply_by_coordinate(grid, p, variable, order) - mean * p;
  const ShiftedLinearSystem system(direct_solution.op, &*direct_solution.preconditioner,
                                   grid.v_cell_count(), order, shift);
  ReducedResolvent model(system, b, p);
  Eigen::VectorXcd points(frequencies.size());
  for (std::size_t k = 0; k < frequencies.size(); ++k) points(k) = {0, frequencies[k]};

  const auto n = static_cast<Eigen::Index>(frequencies.size()),
             m = static_cast<Eigen::Index>(lags.size());
  Eigen::VectorXd values(n + 2 * m + kFurtherValues), last = Eigen::VectorXd::Zero(n);
  const double variance = functional.dot(b);
  while (model.size() < kMost) {
    if (!model.add_krylov_basis_vectors(kStep, deadline)) {
      failure = model.failure_reason();
      return {};
    }
    const Eigen::VectorXd density =
        2 / std::numbers::pi * model.transfer_function_values(functional, points).real();
    const double floor = kFloor * density.cwiseAbs().maxCoeff();
    const bool agree =
        ((density - last).array().abs() <= kAgreement * density.array().abs().max(floor)).all();
    last = density;
    if (agree) {
      const ReducedResolvent::Modes modes = model.reduced_model_modes(functional),
                                    of_smaller_space =
                                        model.reduced_model_modes(functional, model.size() - kStep);
      const Eigen::VectorXd covariance = autocovariance_from_modes(modes, lags);
      const Eigen::VectorXd largest = largest_modes(modes, variance);
      values << density, covariance,
          (covariance - autocovariance_from_modes(of_smaller_space, lags)).cwiseAbs(), variance,
          largest, (largest - largest_modes(of_smaller_space, variance)).cwiseAbs();
      return values;
    }
  }
  failure = fmt::format(
      "the Krylov space of {} vectors does not determine the spectrum to {:g}; reduce the largest "
      "frequency",
      kMost, kAgreement);
  return {};
}

}  // namespace

transform::SpectralDensity solve_spectrum(const problem::Problem& problem,
                                          const FiniteVolumeOptions& options,
                                          transform::StateVariable variable,
                                          const std::vector<double>& frequencies,
                                          const std::vector<double>& lags) {
  validate(options);
  const base::Stopwatch stopwatch;
  transform::SpectralDensity spectrum{.id = solution_id(options), .variable = variable};
  spectrum.frequencies = frequencies;
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  spectrum.reason = transient_unsupported_reason(transformed, options);
  if (!spectrum.reason.empty()) {
    spectrum.status = Status::not_offered;
    return spectrum;
  }
  const problem::MotionScales scales = problem::motion_scales(transformed);
  const double shift = 2 * scales.velocity_deviation / scales.displacement_deviation;
  const int order = options.order.value_or(automatic_scheme_order(transformed));
  const double target = kTargetFraction * options.accuracy;
  const auto on_grid = [&](DirectStationarySolution& direct_solution,
                           const base::Deadline& deadline, std::string& failure) {
    return spectrum_on_grid(frequencies, lags, variable, shift, order, direct_solution, deadline,
                            failure);
  };
  const auto n = static_cast<Eigen::Index>(frequencies.size()),
             m = static_cast<Eigen::Index>(lags.size());
  const auto scale = [n, m](const Eigen::VectorXd& values) -> Eigen::VectorXd {
    Eigen::VectorXd magnitude = values.cwiseAbs();
    // Autocovariances and modes do not determine the grid.
    magnitude.segment(n, 2 * m).setConstant(HUGE_VAL);
    magnitude.tail(2 * kModeValues).setConstant(HUGE_VAL);
    magnitude.head(n) = magnitude.head(n).cwiseMax(kFloor * magnitude.head(n).maxCoeff());
    return magnitude;
  };
  const FunctionalValuesFromGridSequence converged =
      refine_grids_until_converged(transformed, options, target, on_grid, scale);
  spectrum.seconds = stopwatch.seconds();
  if (converged.values.size() == 0) {
    spectrum.reason = converged.failure;
    return spectrum;
  }
  spectrum.density.assign(converged.values.begin(), converged.values.begin() + n);
  const double largest = converged.values.head(n).maxCoeff();
  const Eigen::ArrayXd of_krylov_space =
      kAgreement * converged.values.head(n).array().abs().max(kFloor * largest);
  const Eigen::ArrayXd errors = converged.errors.head(n).array() + of_krylov_space;
  spectrum.error.assign(errors.begin(), errors.end());
  spectrum.variance = converged.values(n + 2 * m);
  spectrum.variance_error = converged.errors(n + 2 * m);
  spectrum.lags = lags;
  const Eigen::VectorXd covariance = converged.values.segment(n, m);
  const Eigen::VectorXd covariance_errors =
      converged.errors.segment(n, m) + converged.values.segment(n + m, m);
  spectrum.autocovariance.assign(covariance.begin(), covariance.end());
  spectrum.autocovariance_error.assign(covariance_errors.begin(), covariance_errors.end());
  const Eigen::Index first_mode = n + 2 * m + 1;
  const Eigen::VectorXd v = converged.values.segment(first_mode, kModeValues),
                        e = converged.errors.segment(first_mode, kModeValues) +
                            converged.values.tail(kModeValues);
  for (Eigen::Index j = 0; j < kModeValues; j += 3) {
    spectrum.modes.push_back({.decay_rate = v(j),
                              .frequency = v(j + 1),
                              .decay_rate_error = e(j),
                              .frequency_error = e(j + 1),
                              .share = v(j + 2)});
  }
  spectrum.details = fmt::format("{} x {} cells", converged.nx, converged.nv);
  const double error = errors.maxCoeff() / largest;
  spectrum.peak = transform::find_spectral_peak(frequencies, spectrum.density);
  spectrum.status = Status::ok;
  if (!(error <= options.accuracy)) {
    spectrum.status = Status::inaccurate;
    spectrum.reason =
        fmt::format("estimated error {:.2g} of the largest density, above the accuracy {:g}; {}",
                    error, options.accuracy, converged.failure);
  }
  return spectrum;
}

}  // namespace fpkcheck::fd_fpk
