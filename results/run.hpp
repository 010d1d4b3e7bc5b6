#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/assessment.hpp"
#include "compare/comparison.hpp"
#include "compare/comparison_axes.hpp"
#include "compare/guaranteed_bounds.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"
#include "transform/solution.hpp"

/// The result of a run, from which tables, figures and the page of the report are made. A result
/// comes from a computation or from the files of a saved run.
namespace fpkcheck::results {

/// A marginal density of one solution, as averages over n bins.
struct DensityCurve {
  std::string solution;
  transform::StateVariable variable;
  std::vector<double> abscissa;  ///< centres of the bins, shape (n)
  std::vector<double> density;   ///< averages over the bins, shape (n)
  std::vector<double> lower;     ///< lower ends of 95 % intervals, shape (n); or empty
  std::vector<double> upper;     ///< upper ends of 95 % intervals, shape (n); or empty

  bool operator==(const DensityCurve&) const = default;
};

/// Returns the widths of the bins of a curve, shape (n).
/// @pre the bins are contiguous, and either all have the same width or have an edge at 0
std::vector<double> bin_widths(const DensityCurve& curve);

/// The joint density p(y, y') of one solution, as averages over cells. All joint densities of a
/// case have the same cells.
struct JointDensity {
  std::string solution;
  transform::GridDensity density;
};

/// Residual-based error estimates of the moments of a solution. The estimates need the density and
/// the problem, but no other solution (docs/residuals.md).
struct MomentErrorEstimate {
  std::string solution;
  transform::Moments corrected;  ///< estimates of the exact moments
  transform::Moments error;      ///< moments of the solution minus `corrected`
};

/// Contributions of the cells of the (y, y') plane to the error of a moment. The integral of
/// `density` over a region is the contribution of the region to the error of the moment.
struct ErrorSource {
  std::string solution;
  std::string moment;              ///< name in transform::kMoments: y2 or v2
  transform::GridDensity density;  ///< contributions to the error per area
};

/// The solutions of one case, their densities and their comparison.
struct CaseResult {
  problem::Problem problem;
  std::vector<transform::Solution> solutions;  ///< by increasing trust
  std::vector<compare::PairDistances> pairs;   ///< distances of all pairs of solutions
  std::vector<compare::ErrorBudgetRow> budget;
  std::vector<DensityCurve> curves;  ///< marginal densities over the comparison bins
  std::vector<JointDensity> joints;
  /// Marginal densities of all solutions over smooth bins (B-spline weights); empty unless a
  /// solution has smooth estimates (compare/smooth_reference.hpp).
  std::vector<DensityCurve> smooth = {};
  /// In the order of the solutions; some solutions have no estimate.
  std::vector<MomentErrorEstimate> moment_error_estimates = {};
  std::vector<ErrorSource> error_sources = {};  ///< sources of the errors of E[y^2] and E[y'^2]
  std::optional<compare::GuaranteedBounds> bounds = {};  ///< empty if not computed
  compare::Assessment assessment = {};

  const std::string& name() const { return problem.name; }
  const transform::Solution* find(std::string_view id) const {
    return transform::find_solution(solutions, id);
  }
  /// Returns the reference (the most accurate solution of the case), or null.
  const transform::Solution* reference() const { return find(assessment.reference); }
  /// Callers must update the assessment after a change of the solutions, distances or error
  /// budgets.
  void assess() { assessment = compare::assess_solutions(solutions, pairs, budget); }
  const DensityCurve* curve(std::string_view solution, transform::StateVariable variable) const;
  const DensityCurve* smooth_curve(std::string_view solution,
                                   transform::StateVariable variable) const;
  const MomentErrorEstimate* moment_error_estimate(std::string_view solution) const;
  const ErrorSource* error_source(std::string_view solution, std::string_view moment) const;
  std::optional<double> l1(std::string_view one, std::string_view other,
                           transform::StateVariable variable) const {
    return compare::l1_distance_between(pairs, one, other, variable);
  }
};

struct ProgramInfo {
  std::string name, version, command;
};

ProgramInfo current_program(const std::string& command);

struct FileChecksum {
  std::string file;
  std::string crc32;  ///< by results::crc32
};

struct Run {
  ProgramInfo program;
  std::vector<CaseResult> cases;
  /// Sentence on the interruption of the run and the missing results; empty for a complete run.
  std::string stopped = {};
  /// Checksums of the files from which the run was read, if the files have checksums.
  std::vector<FileChecksum> files = {};
};

/// Compares and assesses the solutions of a case.
/// @param solutions by increasing trust
CaseResult make_case_result(const problem::Problem& problem, const compare::ComparisonAxes& axes,
                            std::vector<transform::Solution> solutions);

}  // namespace fpkcheck::results
