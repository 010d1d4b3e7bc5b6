#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/comparison_bins.hpp"
#include "compare/guaranteed_bounds.hpp"
#include "compare/pair_distances.hpp"
#include "compare/solution_assessment.hpp"
#include "problem/problem.hpp"
#include "transform/joint_density.hpp"
#include "transform/solution.hpp"

/// The result of a run, computed or read from the files of a saved run. Tables, figures and the
/// report page are made from the result of a run.

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

/// Returns the widths of the bins of a marginal density, shape (n).
/// @pre the bins are contiguous, and have either equal widths or an edge at 0
std::vector<double> bin_widths(const DensityCurve& curve);

/// The joint density p(y, y') of one solution, as averages over cells. All joint densities of a
/// case are stored on the same cells.
struct JointDensity {
  std::string solution;
  transform::GridDensity density;
};

/// Residual-based error estimates of the moments of a solution, which use only the density and the
/// problem, and no other solution (docs/residuals.md).
struct MomentErrorEstimate {
  std::string solution;
  transform::Moments corrected;  ///< corrected moments: estimates of the exact moments
  transform::Moments error;      ///< error estimates: moments of the solution minus `corrected`
};

/// Contributions of the cells of the (y, y') plane to the error of a moment. The integral of
/// `density` over a region is the contribution of the region to the error of the moment.
struct MomentErrorSource {
  std::string solution;
  std::string moment;  ///< name of the moment in transform::kMoments: y2 or v2
  /// Contributions to the error of the moment per unit area of the (y, y') plane.
  transform::GridDensity density;
};

/// The solutions of one case, the densities of the solutions and the comparison of the solutions.
struct CaseResult {
  problem::Problem problem;
  std::vector<transform::Solution> solutions = {};         ///< solutions by increasing trust
  std::vector<compare::SolutionPairDistances> pairs = {};  ///< distances of all pairs of solutions
  std::vector<compare::ErrorBudgetRow> budget = {};
  std::vector<DensityCurve> curves = {};  ///< marginal densities over the comparison bins
  std::vector<JointDensity> joints = {};
  /// Marginal densities of all solutions over smooth bins (B-spline weights); empty unless a
  /// solution has smooth estimates (compare/smooth_reference.hpp).
  std::vector<DensityCurve> smooth = {};
  /// Moment error estimates in the order of the solutions; some solutions have none.
  std::vector<MomentErrorEstimate> moment_error_estimates = {};
  std::vector<MomentErrorSource> error_sources =
      {};  ///< sources of the errors of E[y^2] and E[y'^2]
  /// Guaranteed bounds of the moments; empty if no bounds were computed.
  std::optional<compare::GuaranteedBounds> bounds = {};
  compare::SolutionsAssessment assessment = {};

  const std::string& name() const { return problem.name; }
  const transform::Solution* find(std::string_view id) const {
    return transform::find_solution(solutions, id);
  }
  /// Returns the reference, i.e. the most accurate solution of the case; null without a reference.
  const transform::Solution* reference_solution() const { return find(assessment.reference); }
  /// Recomputes `assessment` from the solutions, distances and error budget. Callers must call
  /// update_assessment() after a change of the solutions, the distances or the error budget.
  void update_assessment() { assessment = compare::assess_solutions(solutions, pairs, budget); }
  const DensityCurve* marginal_curve(std::string_view solution,
                                     transform::StateVariable variable) const;
  const DensityCurve* smooth_curve(std::string_view solution,
                                   transform::StateVariable variable) const;
  /// Returns the residual-based moment error estimate of a solution, or null.
  const MomentErrorEstimate* moment_error_estimate(std::string_view solution) const;
  /// Returns the error sources of one moment (y2 or v2) of a solution, or null.
  const MomentErrorSource* moment_error_source(std::string_view solution,
                                               std::string_view moment) const;
  std::optional<double> l1_distance(std::string_view one, std::string_view other,
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
  std::string crc32;  ///< checksum by results::crc32_hex
};

struct Run {
  ProgramInfo program;
  std::vector<CaseResult> cases;
  /// One sentence on the interruption of the run and the missing results; empty for a complete run.
  std::string stopped = {};
  /// Checksums of the files of a saved run from which the result of the run was read; may be empty.
  std::vector<FileChecksum> files = {};
};

/// Computes the comparison and the assessment of the solutions of a case.
/// @param solutions by increasing trust
CaseResult make_case_result(const problem::Problem& problem, const compare::ComparisonBins& axes,
                            std::vector<transform::Solution> solutions);

/// Converts a marginal density of a solution to the form in which runs store marginal densities.
DensityCurve make_density_curve(compare::SolutionMarginalDensity&& marginal);

/// Returns a sentence on the limiting error (the largest error) of each closure of a case, and a
/// sentence on any disagreement between the finite-volume solution and the simulation. The text on
/// limiting errors is empty if the case has no error budget.
std::string limiting_errors_text(const CaseResult& case_result);

}  // namespace fpkcheck::results
