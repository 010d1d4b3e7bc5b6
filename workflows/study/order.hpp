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

/// What to study: every formulation at every order.
struct OrderStudyOptions {
  std::vector<std::string> formulations;
  std::vector<int> orders;
};

/// What may be studied, by increasing trust: "gaussian", "moment-white"; all formulations of
/// closures that are registered.
std::vector<std::string> formulations(const methods::Registry& registry);

/// A branch of solutions that a closure followed from a problem that it solves exactly.
struct Branch {
  struct Point {
    double fraction;  ///< of the way to the full problem
    double norm;      ///< of the coefficients
    bool fold;        ///< the fraction turns round here
  };
  std::string end;  ///< how it was left, in a word
  double furthest;  ///< greatest fraction
  std::vector<Point> points;
};

/// The branch that a solution tells of, under the path "branch"; nothing where it tells of none.
std::optional<Branch> branch(const transform::Observations& observations);

/// A closure of a formulation at an order.
struct OrderRow {
  std::string formulation;
  int order = 0;
  bool to_converge = false;  ///< a family's usual formulation, and of the problem itself
  transform::Solution solution;
  std::optional<MarginalL1> l1 = {};  ///< to the reference
  /// Mean difference of log10 p over reference densities 1e-5 .. 1e-4.
  std::optional<double> tail_y = {}, tail_ydot = {};
};

struct OrderStudy {
  static constexpr const char* kName = "order";
  problem::Problem problem;
  transform::Solution reference;
  std::vector<OrderRow> rows;  ///< by formulation as asked for, then by order
};

/// Solves a problem by the closures asked for and by the most trusted discretisation of the problem
/// itself, their reference, one after the other so that the times mean something.
/// @throws InputError naming what is no formulation or no order of one
OrderStudy study_orders(const problem::Problem& problem, const OrderStudyOptions& options,
                        const methods::Registry& registry,
                        const methods::ProgressListener& listener);

/// True when the reference is ok, and so is every closure that is to converge; others are looked
/// at.
bool reached(const OrderStudy& study);

/// The parts of `output`. JSON: the reference's id, status and reason, and the rows: what
/// summary.json has of a solution, but for its identity, options and moments, and the distances.
std::string json(const OrderStudy& study, const std::string& command);
std::string csv(const OrderStudy& study);
/// The rows, reasons, folds met, and what the orders are worth.
std::string table(const OrderStudy& study, const report::TextFormat& format);
/// L1 distances over the order, and below them the branches that were followed.
std::string figure(const OrderStudy& study, const std::string& file_stem,
                   report::FigureWidth width = report::FigureWidth::screen);

Record record(const OrderRow& row);

}  // namespace fpkcheck::study
