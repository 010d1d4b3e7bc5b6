#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// The formulations and orders n of the closures in an order study. The study solves every
/// combination of formulation and order.
struct ClosureOrderStudyOptions {
  std::vector<std::string> formulations;
  std::vector<int> orders;
};

/// The names of all closure formulations in the registry, by increasing trust: "gaussian",
/// "moment-white". An order study accepts these names.
std::vector<std::string> closure_formulations(const methods::Registry& registry);

/// A branch of solutions that the continuation of a closure followed. The branch begins at a
/// problem with a known exact solution.
struct SolutionBranch {
  struct Point {
    double fraction;  ///< fraction of the way to the full problem
    double norm;      ///< norm of the coefficients
    bool fold;        ///< the fraction has an extremum here
  };
  std::string end;          ///< how the branch was left: a word, as in docs/glossary.md
  double largest_fraction;  ///< largest fraction
  std::vector<Point> points;
};

/// The branch of solutions that the metrics of a solution contain under the path "branch"; empty if
/// the metrics contain no branch.
std::optional<SolutionBranch> solution_branch(const transform::Metrics& metrics);

/// A row of an order study: the closure of one formulation and order, with its distances to the
/// reference.
struct ClosureOrderRow {
  std::string formulation;
  int order = 0;
  bool must_converge = false;  ///< default variant of its family that solves the full problem
  transform::Solution solution;
  std::optional<MarginalL1Distances> l1 = {};  ///< distance to the reference
  /// The tail distance: mean |log10 p - log10 reference| over the bins with a reference density of
  /// 1e-5 .. 1e-4.
  std::optional<double> tail_y = {}, tail_ydot = {};
};

struct ClosureOrderStudy {
  static constexpr const char* kName = "order";
  problem::Problem problem;
  transform::Solution reference;
  std::vector<ClosureOrderRow> rows;  ///< by formulation in the given order, then by order n
};

/// Solves a problem by the given closures and by their reference, the most trusted discretisation
/// of the full problem. The methods run one after another, so that their wall-clock times are
/// comparable.
/// @throws InputError with the name of an unknown formulation or the value of an unknown order
ClosureOrderStudy study_closure_orders(const problem::Problem& problem,
                                       const ClosureOrderStudyOptions& options,
                                       const methods::Registry& registry,
                                       const methods::ProgressListener& listener);

/// Whether the reference and every closure with `must_converge` have status ok.
bool has_converged(const ClosureOrderStudy& study);

/// The files and texts of an order study, from which make_report() makes a StudyReport. The JSON
/// contains id, status and reason of the reference, and a row for each closure. The row of a
/// closure has the keys of a solution in summary.json (except identity, options and moments) and
/// the distances.
std::string json(const ClosureOrderStudy& study, const std::string& command);
std::string csv(const ClosureOrderStudy& study);
/// The table of the closures, the reasons of closures that are not ok, the folds of branches, and
/// the convergence with increasing order n.
std::string table(const ClosureOrderStudy& study, const report::TextFormat& format);
/// The L1 distances against the order n, and below these panels the branches of solutions.
report::Figure figure(const ClosureOrderStudy& study);

Record make_record(const ClosureOrderRow& row);

}  // namespace fpkcheck::study
