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

/// The type of the result of a run. A result is complete before any file is written. Tables,
/// figures and the page of the report are made from this type, both for computed runs and for runs
/// that were read from files.
namespace fpkcheck::results {

/// A marginal density of one solution, as averages over n bins (a curve of marginals.csv).
struct Curve {
  std::string solution;  ///< id of the solution
  transform::Variable variable;
  std::vector<double> abscissa;  ///< centres of the bins, shape (n)
  std::vector<double> density;   ///< averages over the bins, shape (n)
  std::vector<double> lower;     ///< lower ends of the 95 % intervals, shape (n); or empty
  std::vector<double> upper;     ///< upper ends of the 95 % intervals, shape (n); or empty

  bool operator==(const Curve&) const = default;
};

/// The widths of the bins of a curve, shape (n).
/// @pre the bins are contiguous, and either all have the same width or have an edge at 0
std::vector<double> bin_widths(const Curve& curve);

/// The joint density of (y, y') of one solution, as averages over cells. All joint densities of a
/// case have the same cells.
struct JointDensity {
  std::string solution;  ///< id of the solution
  transform::GridDensity density;
};

/// Residual-based error estimates of the moments of a solution. The estimates are computed from the
/// density of the solution and the problem, without another solution (docs/residuals.md).
struct MomentErrorEstimate {
  std::string solution;          ///< id of the solution
  transform::Moments corrected;  ///< corrected moments E[f]
  transform::Moments error;      ///< moments of the solution minus the corrected moments
};

/// The sources of the error of a moment of a solution: the density of contributions to this error
/// over the cells of the joint densities. The integral of the density over a region is the
/// contribution of the region to the error of the moment. The integral over all cells is the error
/// of the moment, apart from the contribution of the region outside the cells.
struct ErrorSource {
  std::string solution;            ///< id of the solution
  std::string moment;              ///< name of the moment in transform::kMoments: y2, v2
  transform::GridDensity density;  ///< contributions to the error per area
};

/// The result of a run for one case.
struct CaseResult {
  problem::Problem problem;
  std::vector<transform::Solution> solutions;   ///< by increasing trust
  std::vector<compare::PairDistances> pairs;    ///< distances of all pairs of solutions
  std::vector<compare::ErrorBudgetRow> budget;  ///< error budgets of the closures
  std::vector<Curve> curves;                    ///< marginal densities over the comparison bins
  std::vector<JointDensity> joints;  ///< joint densities of all solutions with a joint density
  /// Marginal densities of all solutions over smooth bins, if a solution has smooth estimates
  /// (compare/smooth_reference.hpp); else empty.
  std::vector<Curve> smooth = {};
  /// Moment error estimates, in the order of the solutions. Some solutions have no estimate.
  std::vector<MomentErrorEstimate> moment_error_estimates = {};
  std::vector<ErrorSource> error_sources = {};  ///< sources of the errors of E[y^2] and E[y'^2]
  std::optional<compare::GuaranteedBounds> bounds =
      {};                               ///< guaranteed bounds; empty if not computed
  compare::Assessment assessment = {};  ///< the assessment of the solutions by assess()

  const std::string& name() const { return problem.name; }
  /// The solution with this id; null if there is none.
  const transform::Solution* find(std::string_view id) const {
    return transform::find_solution(solutions, id);
  }
  /// The reference of the case; null if there is none.
  const transform::Solution* reference() const { return find(assessment.reference); }
  /// Assesses the solutions of the case. A function that changes the solutions, their distances or
  /// the error budgets calls this function afterwards.
  void assess() { assessment = compare::assess_solutions(solutions, pairs, budget); }
  /// The marginal density of a solution over the comparison bins; null if there is none.
  const Curve* curve(std::string_view solution, transform::Variable variable) const;
  /// The marginal density of a solution over smooth bins; null if there is none.
  const Curve* smooth_curve(std::string_view solution, transform::Variable variable) const;
  /// The moment error estimates of a solution; null if there are none.
  const MomentErrorEstimate* moment_error_estimate(std::string_view solution) const;
  /// The sources of the error of a moment of a solution; null if there are none.
  const ErrorSource* error_source(std::string_view solution, std::string_view moment) const;
  /// The L1 distance between two solutions of this case, as compare::l1_distance_between.
  std::optional<double> l1(std::string_view one, std::string_view other,
                           transform::Variable variable) const {
    return compare::l1_distance_between(pairs, one, other, variable);
  }
};

/// The program and the command of a run.
struct Program {
  std::string name, version, command;
};

/// The name and version of this program, and the command of a run.
/// @param command the command line of the run
Program this_program(const std::string& command);

/// The checksum of a file of a run at the time of saving.
struct FileChecksum {
  std::string file;   ///< name of the file
  std::string crc32;  ///< checksum, as by results::crc32
};

/// The result of a run for all its cases.
struct Run {
  Program program;
  std::vector<CaseResult> cases;
  /// A sentence on the interruption of the run and its missing parts; empty for a complete run.
  std::string stopped = {};
  /// Checksums of the files from which the run was read. Empty for a computed run, and for a run
  /// that an older version saved.
  std::vector<FileChecksum> files = {};
};

/// Compares and assesses the solutions of a case and returns the result for the case.
/// @param solutions by increasing trust
CaseResult make_case_result(const problem::Problem& problem, const compare::ComparisonAxes& axes,
                            std::vector<transform::Solution> solutions);

}  // namespace fpkcheck::results
