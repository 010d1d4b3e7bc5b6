#include "fd_fpk/functionals/spectrum.hpp"

#include <fmt/format.h>

#include <complex>
#include <numbers>
#include <utility>

#include "fd_fpk/applicability.hpp"
#include "fd_fpk/functionals/grid_sequence.hpp"
#include "fd_fpk/functionals/reduced_resolvent.hpp"
#include "fd_fpk/operator/observables.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

// Error of each density, relative to this density, at which no finer grid is tried, as a fraction of
// Options::accuracy
constexpr double kTargetFraction = 0.2;
// Smallest density, relative to the largest density, to which relative errors refer
constexpr double kFloor = 1e-3;
// Agreement of two successive Krylov spaces, relative to the same densities, which is part of the
// errors
constexpr double kAgreement = 1e-5;

// Returns the densities at the frequencies and then the variance. The Krylov space grows until the
// densities of two successive spaces agree.
Eigen::VectorXd spectrum_on_grid(const std::vector<double>& frequencies,
                                 transform::StateVariable variable, double shift, int order,
                                 DirectSolution& on, const Deadline& deadline,
                                 std::string& failure) {
  constexpr int kStep = 10, kMost = 200;
  const Grid& grid = on.discretisation.grid;
  const Eigen::VectorXd& p = *on.averages;
  const Eigen::VectorXd functional = coordinate_functional(grid, variable, order);
  const double mean = functional.dot(p) / on.op.total_mass(p);
  const Eigen::VectorXd b = multiply_by_coordinate(grid, p, variable, order) - mean * p;
  const ShiftedSystem system(on.op, *on.preconditioner, grid.nv(), order, shift);
  ReducedResolvent model(system, b, p);
  Eigen::VectorXcd points(frequencies.size());
  for (std::size_t k = 0; k < frequencies.size(); ++k) points(k) = {0, frequencies[k]};

  Eigen::VectorXd values(frequencies.size() + 1), last = Eigen::VectorXd::Zero(frequencies.size());
  values.tail(1)(0) = functional.dot(b);
  while (model.size() < kMost) {
    if (!model.extend(kStep, deadline)) {
      failure = model.failure_reason();
      return {};
    }
    const Eigen::VectorXd density =
        2 / std::numbers::pi * model.transfer(functional, points).real();
    const double floor = kFloor * density.cwiseAbs().maxCoeff();
    const bool agree =
        ((density - last).array().abs() <= kAgreement * density.array().abs().max(floor)).all();
    last = density;
    if (agree) {
      values.head(density.size()) = density;
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

transform::Spectrum solve_spectrum(const problem::Problem& problem, const Options& options,
                                   transform::StateVariable variable,
                                   const std::vector<double>& frequencies) {
  validate(options);
  const Stopwatch stopwatch;
  transform::Spectrum spectrum{.id = solution_id(options), .variable = variable};
  spectrum.frequencies = frequencies;
  const problem::Problem seen =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  spectrum.reason = transient_unsupported_reason(seen, options);
  if (!spectrum.reason.empty()) {
    spectrum.status = Status::not_offered;
    return spectrum;
  }
  const problem::MotionScales scales = problem::scales(seen);
  const double shift = 2 * scales.velocity_deviation / scales.displacement_deviation;
  const double target = kTargetFraction * options.accuracy;
  const auto on_grid = [&](DirectSolution& on, const Deadline& deadline, std::string& failure) {
    return spectrum_on_grid(frequencies, variable, shift, transport_order(options), on, deadline,
                            failure);
  };
  const auto scale = [](const Eigen::VectorXd& values) -> Eigen::VectorXd {
    Eigen::VectorXd magnitude = values.cwiseAbs();
    const auto n = values.size() - 1;
    magnitude.head(n) = magnitude.head(n).cwiseMax(kFloor * magnitude.head(n).maxCoeff());
    return magnitude;
  };
  const ConvergedValues converged = converge_on_grids(seen, options, target, on_grid, scale);
  spectrum.seconds = stopwatch.seconds();
  if (converged.values.size() == 0) {
    spectrum.reason = converged.failure;
    return spectrum;
  }
  const auto n = static_cast<Eigen::Index>(frequencies.size());
  spectrum.density.assign(converged.values.begin(), converged.values.begin() + n);
  const double largest = converged.values.head(n).maxCoeff();
  const Eigen::ArrayXd of_krylov_space =
      kAgreement * converged.values.head(n).array().abs().max(kFloor * largest);
  const Eigen::ArrayXd errors = converged.errors.head(n).array() + of_krylov_space;
  spectrum.error.assign(errors.begin(), errors.end());
  spectrum.variance = converged.values(n);
  spectrum.variance_error = converged.errors(n);
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
