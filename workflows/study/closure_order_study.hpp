#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "workflows/study/study_record.hpp"
#include "workflows/study/study_report.hpp"

namespace fpkcheck::study {

/// Options of an order study, which solves a problem by every combination of closure formulation
/// and order n.
struct ClosureOrderStudyOptions {
  std::vector<std::string> formulations;
  std::vector<int> orders;
};

/// Returns the names of all closure formulations by increasing trust, e.g. "gaussian",
/// "moment-white".
std::vector<std::string> closure_formulations(const methods::SolverRegistry& registry);

/// Branch of closure solutions that begins at a problem with a known exact solution.
struct SolutionBranch {
  struct Point {
    /// Position on a solution branch, from 0 (exactly solved problem) to 1 (full problem).
    double fraction;
    double norm;  ///< norm of the coefficients of the closure
    bool fold;    ///< whether the fraction has an extremum at this point
  };
  std::string end;  ///< reason for the end of the branch, a word of docs/glossary.md
  double largest_fraction;
  std::vector<Point> points;
};

/// Reads the solution branch from the metrics "branch" of a solution. If a solution has no metrics
/// "branch", the result is empty.
std::optional<SolutionBranch> read_solution_branch(const transform::Metrics& metrics);

struct ClosureOrderStudyRow {
  std::string formulation;
  int order = 0;
  /// Whether the study fails if this closure, a default variant that solves the full problem, does
  /// not converge.
  bool must_converge = false;
  transform::Solution solution;
  /// L1 distances of the closure's p(y) and p(y') from the reference densities.
  std::optional<MarginalL1Distances> l1 = {};
  /// Tail distances: mean |log10 p - log10 reference| over the bins with a reference density of
  /// 1e-5 .. 1e-4.
  std::optional<double> tail_y = {}, tail_ydot = {};
};

struct ClosureOrderStudy {
  static constexpr const char* kName = "order";
  static constexpr const char* kFileStem = "study-order";
  problem::Problem problem;
  transform::Solution reference;
  /// Rows of the order study, sorted by closure formulation, then by closure order n.
  std::vector<ClosureOrderStudyRow> rows;
};

/// Solves a problem by the given closures and by the reference, the most trusted discretisation of
/// the full problem. The methods of an order study run one after another, since parallel runs would
/// distort the wall-clock times.
/// @throws InputError for an unknown formulation or order
ClosureOrderStudy study_closure_orders(const problem::Problem& problem,
                                       const ClosureOrderStudyOptions& options,
                                       const methods::SolverRegistry& registry,
                                       const methods::ProgressListener& listener);

/// Returns whether the reference and every closure with `must_converge` have the status `ok`.
bool has_converged(const ClosureOrderStudy& study);

/// Files and texts of an order study of closures, from which make_study_report() makes a
/// StudyReport. In the JSON text of an order study, the row of a closure has the keys of a solution
/// in summary.json, except identity, options and moments.
std::string study_json_text(const ClosureOrderStudy& study, const std::string& command);
std::string study_csv_text(const ClosureOrderStudy& study);
/// Returns the table of the closures, the reasons for statuses other than `ok`, the folds of
/// solution branches and the convergence.
std::string study_table_text(const ClosureOrderStudy& study,
                             const report::TerminalTextFormat& format);
/// Returns a figure with panels of the L1 distances against the closure order n and panels of the
/// solution branches.
report::Figure study_figure(const ClosureOrderStudy& study);

StudyRecord make_study_record(const ClosureOrderStudyRow& row);

}  // namespace fpkcheck::study
