#include "fd_fpk/functionals/passage_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <utility>

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;
using transform::ValueWithError;

// Error, as a fraction of FiniteVolumeOptions::accuracy, at which no finer grid is tried
constexpr double kPassageTargetFraction = 0.5;

// Returns the survival probabilities at the given times, as sums over the modes of the Krylov
// space. From rest, no passage occurs before the first impulse, which arrives at the rate
// `waiting_rate`.
Eigen::VectorXd survival_probabilities(const ReducedResolvent::Modes& modes,
                                       const std::vector<double>& times, double waiting_rate) {
  Eigen::VectorXd values(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double t = times[k];
    const double waiting = waiting_rate > 0 ? std::exp(-waiting_rate * t) : 0;
    std::complex<double> sum = waiting;
    for (Eigen::Index j = 0; j < modes.rates.size(); ++j) {
      const std::complex<double> a = modes.rates(j), decayed = std::exp(a * t);
      sum += modes.coefficients(j) *
             (waiting_rate > 0 ? waiting_rate * (decayed - waiting) / (a + waiting_rate) : decayed);
    }
    values(static_cast<Eigen::Index>(k)) = sum.real();
  }
  return values;
}

Eigen::VectorXd passage_values(ReducedResolvent& model, const PassageInitialConditions& starts,
                               const std::vector<double>& times) {
  const Eigen::VectorXcd origin = Eigen::VectorXcd::Zero(1);
  const auto n = static_cast<Eigen::Index>(times.size());
  Eigen::VectorXd values = Eigen::VectorXd::Zero(kValueCount + 2 * n);
  const auto of_stationary = model.reduced_model_modes(starts.from_stationary);
  // Modes with negligible coefficients may be artefacts of the Krylov space.
  constexpr double kSmallestCoefficient = 1e-6;
  values(kHazard) = HUGE_VAL;
  for (Eigen::Index j = 0; j < of_stationary.rates.size(); ++j) {
    if (std::abs(of_stationary.coefficients(j)) < kSmallestCoefficient) continue;
    values(kHazard) = std::min(values(kHazard), -of_stationary.rates(j).real());
  }
  values(kFromStationary) =
      model.transfer_function_values(starts.from_stationary, origin)(0).real();
  values.segment(kValueCount + n, n) = survival_probabilities(of_stationary, times, 0);
  if (starts.from_point) {
    const double rate = starts.waiting_rate;
    values(kFromPoint) = model.transfer_function_values(*starts.from_point, origin)(0).real() +
                         (rate > 0 ? 1 / rate : 0);
    values.segment(kValueCount, n) =
        survival_probabilities(model.reduced_model_modes(*starts.from_point), times, rate);
  }
  return values;
}

// Returns the magnitudes to which errors are relative: the values, and 1 for the probabilities of
// survival and of the upper barrier, since small probabilities have large relative errors.
Eigen::VectorXd passage_magnitudes(const Eigen::VectorXd& values) {
  Eigen::VectorXd magnitudes = values.cwiseAbs();
  // A mean time without an initial state and the rate of upcrossings of an energy are 0.
  for (const auto absent : {kFromPoint, kRiceRate}) {
    if (magnitudes(absent) == 0) magnitudes(absent) = 1;
  }
  for (const auto probability : {kUpperExitFromPoint, kUpperExitFromStationary}) {
    magnitudes(probability) = 1;
  }
  magnitudes.tail(values.size() - kValueCount).setOnes();
  return magnitudes;
}

// Returns the largest accepted differences between the values of two successive Krylov spaces. The
// survival probability at short times, to which many modes contribute, converges last.
// @param accuracy FiniteVolumeOptions::accuracy
Eigen::VectorXd krylov_errors(const Eigen::VectorXd& values, double accuracy) {
  constexpr double kOfValues = 1e-5, kOfSurvival = 1e-3, kFractionOfAccuracy = 0.1;
  Eigen::VectorXd errors = kOfValues * values.cwiseAbs();
  errors.tail(values.size() - kValueCount)
      .setConstant(std::min(kOfSurvival, kFractionOfAccuracy * accuracy));
  return errors;
}

}  // namespace

Eigen::VectorXd compute_passage_values(ReducedResolvent& model,
                                       const PassageInitialConditions& starts,
                                       const std::vector<double>& times, double accuracy,
                                       const base::Deadline& deadline, std::string& failure) {
  constexpr int kStep = 10, kMost = 120;
  Eigen::VectorXd last;
  bool agree = false;
  while (!agree && model.size() < kMost) {
    if (!model.add_krylov_basis_vectors(kStep, deadline)) {
      failure = model.failure_reason();
      return {};
    }
    Eigen::VectorXd values = passage_values(model, starts, times);
    agree = last.size() > 0 &&
            ((values - last).array().abs() <= krylov_errors(values, accuracy).array()).all();
    last = values;
  }
  if (!agree) {
    failure = fmt::format(
        "the Krylov space of {} vectors does not determine the passage; choose a barrier that is "
        "crossed more often, or omit short times",
        kMost);
    return {};
  }
  const bool is_from_point_valid = !starts.from_point || last(kFromPoint) > 0;
  if (!(last(kHazard) > 0 && last(kFromStationary) > 0 && is_from_point_valid)) {
    failure =
        "the operator below the barrier has a growing mode: the cells do not resolve the motion "
        "there; choose a barrier farther from the wall, or use mcs";
    return {};
  }
  return last;
}

void solve_passage_on_grids(const SolvePassageOnGrid& solve_on_grid,
                            const FiniteVolumeOptions& options, int order,
                            std::vector<double> times, bool has_start, const char* element_name,
                            const base::Deadline& deadline,
                            transform::FirstPassageResult& passage) {
  if (times.empty()) {
    constexpr double kCoarse = 0.5;
    const FunctionalValuesOnGrid coarse = solve_on_grid(kCoarse, {}).values_on_grid;
    if (coarse.values.size() == 0) {
      passage.reason = coarse.failure;
      return;
    }
    times = transform::automatic_survival_times(coarse.values(kFromStationary));
  }
  // The map of the finest grid; two threads evaluate the first two grids.
  std::mutex map_mutex;
  double finest = 0;
  const auto evaluate = [&](double refinement) {
    PassageResultOnGrid result = solve_on_grid(refinement, times);
    const std::lock_guard lock(map_mutex);
    if (result.values_on_grid.values.size() > 0 && refinement > finest) {
      finest = refinement;
      passage.mean_passage_times_by_start = std::move(result.mean_passage_times_by_start);
    }
    return std::move(result.values_on_grid);
  };
  const FunctionalValuesFromGridSequence converged = refine_grids_until_converged(
      evaluate, order, kPassageTargetFraction * options.accuracy, passage_magnitudes, deadline);
  if (converged.values.size() == 0) {
    passage.mean_passage_times_by_start.reset();
    passage.reason = converged.failure;
    return;
  }
  const Eigen::VectorXd errors =
      converged.errors + krylov_errors(converged.values, options.accuracy);
  const auto at = [&](Eigen::Index k) -> ValueWithError {
    return {converged.values(k), errors(k)};
  };
  passage.hazard = at(kHazard);
  if (has_start) passage.mean_from_point = at(kFromPoint);
  passage.mean_from_stationary = at(kFromStationary);
  if (converged.values(kRiceRate) > 0) passage.rice_rate = at(kRiceRate);
  passage.probability_below = at(kProbabilityBelow);
  if (converged.values(kUpperExitFromStationary) > 0) {  // two barriers
    if (has_start) passage.upper_exit_from_point = at(kUpperExitFromPoint);
    passage.upper_exit_from_stationary = at(kUpperExitFromStationary);
  }
  passage.times = times;
  const auto n = static_cast<Eigen::Index>(times.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    if (has_start) passage.survival_from_point.push_back(at(kValueCount + k));
    passage.survival_from_stationary.push_back(at(kValueCount + n + k));
  }
  passage.details = fmt::format("{} x {} {}", converged.nx, converged.nv, element_name);
  const double error = (errors.array() / passage_magnitudes(converged.values).array()).maxCoeff();
  passage.status = Status::ok;
  if (!(error <= options.accuracy)) {
    passage.status = Status::inaccurate;
    if (passage.hazard->error > passage.hazard->value) {
      passage.reason = fmt::format(
          "rare passages: the hazard {:.2g} is below its discretisation error {:.2g}; use mcs{}{}",
          passage.hazard->value, passage.hazard->error, converged.failure.empty() ? "" : "; ",
          converged.failure);
      return;
    }
    passage.reason = fmt::format("estimated relative error {:.2g}, above the accuracy {:g}; {}",
                                 error, options.accuracy, converged.failure);
  }
}

}  // namespace fpkcheck::fd_fpk
