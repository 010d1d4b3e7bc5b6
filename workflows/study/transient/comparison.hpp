#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/format.hpp"
#include "transform/transient.hpp"
#include "workflows/study/functionals/functional.hpp"

/// The command `run --until T`: densities over time by finite volumes, closures and simulation.
namespace fpkcheck::study {

struct TransientComparisonOptions : FunctionalOptions {
  TransientComparisonOptions() {
    methods = "fd-kf,epc-polar-n6,epc-moment-n6,mcs";
    max_seconds = 20;
  }

  double until = 0;
  int snapshots = 20;
  bool periodic =
      false;  ///< whether the densities are those of the periodic state of period `until`
  std::optional<double> start_y{}, start_v{};            ///< deviations of the initial density
  std::optional<double> start_mean_y{}, start_mean_v{};  ///< means of the initial density
};

const base::Description<TransientComparisonOptions>& transient_comparison_option_descriptions();

struct TransientComparison {
  static constexpr const char* kFileStem = "over_time";
  problem::Problem problem;
  TransientComparisonOptions options;
  std::vector<transform::Transient> solutions;
};

/// @throws InputError for invalid options
TransientComparison compare_over_time(const problem::Problem& problem,
                                      const TransientComparisonOptions& options,
                                      const methods::ProgressListener& listener);

/// Changes the status `ok` to `inaccurate` if the mass in the bins differs from 1, if a distance to
/// the reference contradicts the accuracy, or if the L1 error exceeds it. The error is the estimate
/// of the method, or the distance to the reference plus the error of the reference if that is
/// smaller.
/// @param compared_with reference that solves the same equation; null without a reference
void require_accurate(double accuracy, const transform::Transient* compared_with,
                      transform::Transient& solution);

/// Returns the solution with which the others are compared: the first by finite volumes, or else
/// the first simulation, with a density at the end time and the status ok or inaccurate; null if
/// there is none.
const transform::Transient* reference(const TransientComparison& study);

/// Returns whether the status of finite volumes and simulations that support the problem is `ok`,
/// and at least one has this status. Closures may fail.
bool has_converged(const TransientComparison& study);

std::string json(const TransientComparison& study, const std::string& command);
/// Returns the marginal densities with the columns case, solution, time, variable, abscissa,
/// density, lower, upper.
std::string csv(const TransientComparison& study);
std::string table(const TransientComparison& study, const report::TextFormat& format);
report::Figure figure(const TransientComparison& study);
/// Returns the bytes of a netCDF-4 file with the marginal densities p_y(solution, time, y) and
/// p_ydot(solution, time, ydot), NaN where a solution has none; empty without a density.
std::string netcdf(const TransientComparison& study, const std::string& command);

}  // namespace fpkcheck::study
