#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/options/option_description.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/text/text_layout.hpp"
#include "transform/transient.hpp"
#include "workflows/study/functionals/functional.hpp"
#include "workflows/study/study_record.hpp"

/// The command `run --until T`, which computes densities over time by finite volumes, closures and
/// simulation.
namespace fpkcheck::study {

struct TransientComparisonOptions : FunctionalCommandOptions {
  TransientComparisonOptions() {
    methods = "fd-kf,epc-polar-n6,epc-moment-n6,mcs";
    max_seconds = 20;
  }

  double until = 0;
  int snapshots = 20;
  /// Whether the command computes the periodic state of period `until`.
  bool periodic = false;
  std::optional<double> start_y{}, start_v{};            ///< deviations of the initial density
  std::optional<double> start_mean_y{}, start_mean_v{};  ///< means of the initial density
};

const base::OptionsDescription<TransientComparisonOptions>&
transient_comparison_option_descriptions();

struct TransientComparison {
  static constexpr const char* kFileStem = "over_time";
  problem::Problem problem;
  TransientComparisonOptions options;
  std::vector<transform::TransientDensities> solutions;
};

/// @throws InputError for invalid options
TransientComparison compare_over_time(const problem::Problem& problem,
                                      const TransientComparisonOptions& options,
                                      const methods::ProgressListener& listener);

/// Changes the status `ok` to `inaccurate` if the mass in the bins differs from 1, if the L1 error
/// exceeds `accuracy`, or if a distance to the reference contradicts an L1 error within `accuracy`.
/// The L1 error is the smaller of two numbers: the error estimate of the method, and the distance
/// to the reference plus the error of the reference.
/// @param compared_with reference that solves the same equation; null without a reference
void require_accurate(double accuracy, const transform::TransientDensities* compared_with,
                      transform::TransientDensities& solution);

/// Returns the reference solution, with which all other solutions are compared. The reference is
/// the first finite-volume solution with a density at the end time and the status `ok` or
/// `inaccurate`. Without a suitable finite-volume solution, the reference is the first simulation
/// with a density at the end time and the status `ok` or `inaccurate`. The returned pointer is null
/// if neither a finite-volume solution nor a simulation is suitable as reference.
const transform::TransientDensities* find_reference_solution(const TransientComparison& study);

/// Returns whether at least one finite-volume solution or simulation has the status `ok`, and all
/// other finite-volume solutions and simulations have the status `ok` or `not_offered`. Failures of
/// closures are ignored.
bool has_converged(const TransientComparison& study);

const transform::Marginal& marginal_of_variable(const transform::TransientDensitySnapshot& snapshot,
                                                transform::StateVariable variable);

/// Returns the L1 distances of a solution to the reference solution at one snapshot. The result is
/// empty for the reference solution itself, or if one of the two solutions lacks the snapshot.
std::optional<MarginalL1Distances> l1_distances_at(const transform::TransientDensities& solution,
                                                   const transform::TransientDensities& reference,
                                                   std::size_t snapshot);

/// Returns the indices of evenly spaced snapshots with at most `most_intervals` intervals between
/// them. The evenly spaced snapshots include the first and the last snapshot of the comparison.
std::vector<std::size_t> evenly_spaced_snapshots(const TransientComparison& study,
                                                 int most_intervals);

/// Returns the status, the errors, the largest distances to the reference and the computing time of
/// a solution in one sentence.
/// @param compared_with the reference solution; null without a reference
std::string solution_summary_text(const TransientComparison& study,
                                  const transform::TransientDensities& solution,
                                  const transform::TransientDensities* compared_with);

std::string study_json_text(const TransientComparison& study, const std::string& command);
/// Returns the marginal densities as CSV with the columns case, solution, time, variable, abscissa,
/// density, lower, upper.
std::string study_csv_text(const TransientComparison& study);
std::string study_table_text(const TransientComparison& study,
                             const report::TerminalTextFormat& format);
report::Figure study_figure(const TransientComparison& study);
/// Returns the bytes of a netCDF-4 file with the marginal densities p_y(solution, time, y) and
/// p_ydot(solution, time, ydot). A missing density has the value NaN. The string of bytes is empty
/// if no solution has a density.
std::string study_netcdf_bytes(const TransientComparison& study, const std::string& command);
/// Returns the self-contained page over_time.html. A slider on the page selects a time; the plots
/// show the densities of all solutions at this time, and a table shows the moments and L1
/// distances. The page over_time.html is empty if no solution has a density.
std::string study_page_html(const TransientComparison& study, const std::string& command);

}  // namespace fpkcheck::study
