#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/options.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// Formulations and orders of an order study, which solves every combination.
struct OrderStudyOptions {
  std::vector<std::string> formulations;
  std::vector<int> orders;
};

/// Names of all formulations that can be studied (closures of the registry), by increasing trust:
/// "gaussian", "moment-white".
std::vector<std::string> formulations(const methods::Registry& registry);

/// A branch of solutions that a closure followed, from a problem with a known exact solution.
struct Branch {
  struct Point {
    double fraction;  ///< fraction of the way to the full problem
    double norm;      ///< norm of the coefficients
    bool fold;        ///< the fraction has an extremum here
  };
  std::string end;          ///< how the branch was left: a word, as in docs/glossary.md
  double largest_fraction;  ///< largest fraction
  std::vector<Point> points;
};

/// The branch in the metrics of a solution, under the path "branch"; empty without a branch.
std::optional<Branch> branch(const transform::Metrics& metrics);

/// A closure of one formulation and order.
struct OrderRow {
  std::string formulation;
  int order = 0;
  bool must_converge = false;  ///< default variant of its family that solves the full problem
  transform::Solution solution;
  std::optional<MarginalL1> l1 = {};  ///< distance to the reference
  /// Mean |log10 p - log10 reference| where the reference density is 1e-5 .. 1e-4.
  std::optional<double> tail_y = {}, tail_ydot = {};
};

struct OrderStudy {
  static constexpr const char* kName = "order";
  problem::Problem problem;
  transform::Solution reference;
  std::vector<OrderRow> rows;  ///< by formulation in the given order, then by order n
};

/// Solves a problem by the given closures and by their reference, the most trusted discretisation
/// of the full problem; one after the other, so that the times are comparable.
/// @throws InputError naming an unknown formulation or order
OrderStudy study_orders(const problem::Problem& problem, const OrderStudyOptions& options,
                        const methods::Registry& registry,
                        const methods::ProgressListener& listener);

/// True when the reference is ok, and so is every closure with `must_converge`.
bool has_converged(const OrderStudy& study);

/// The parts of a StudyOutput. JSON: id, status and reason of the reference; rows with the keys of
/// summary.json for a solution (without identity, options and moments) and the distances.
std::string json(const OrderStudy& study, const std::string& command);
std::string csv(const OrderStudy& study);
/// The rows, the reasons, the folds of branches, and the convergence over the orders.
std::string table(const OrderStudy& study, const report::TextFormat& format);
/// L1 distances against the order, and below them the branches that were followed.
std::string figure(const OrderStudy& study, const std::string& file_stem,
                   report::FigureWidth width = report::FigureWidth::screen);

Record record(const OrderRow& row);

}  // namespace fpkcheck::study
