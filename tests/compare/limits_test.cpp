#include "results/run.hpp"

#include <gtest/gtest.h>

#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

ErrorBudgetPart part(ModelApproximation approximation, const std::string& from,
                     const std::string& to, double l1) {
  return {.approximations = {approximation},
          .from = from,
          .to = to,
          .l1 = l1,
          .tail = 0,
          .uncertainty = 1e-5};
}

struct Budgets {
  std::vector<Solution> solutions;
  std::vector<ErrorBudgetRow> rows;
  std::vector<SolutionPairDistances> pairs;  ///< of the references

  std::string limits() const {
    auto case_result = tests::made_up_case();
    case_result.solutions = solutions;
    case_result.pairs = pairs;
    case_result.budget = rows;
    case_result.update_assessment();
    return results::limiting_errors_text(case_result);
  }

  /// Finite differences and the simulation, and their distance in both variables.
  void add_references(double l1) {
    add_solution("fd-kf", Status::ok);
    add_solution("mcs", Status::ok);
    solutions.back().sampling = {.y = 6e-4, .ydot = 6e-4, .y_99 = 8e-4, .ydot_99 = 8e-4};
    for (const auto variable : transform::kVariables) {
      pairs.push_back({.a = "fd-kf", .b = "mcs", .variable = variable, .distances = {}});
      pairs.back().distances.l1 = l1;
    }
  }

  void add_solution(const std::string& id, Status status) {
    solutions.push_back({.identity = {.id = id, .method = "epc"}, .status = status});
  }

  /// One closure against the simulation, the same in both variables.
  void add(const std::string& id, double closure, double impact, double total,
           Status status = Status::ok) {
    add_solution(id, status);
    for (const auto variable : transform::kVariables) {
      ErrorBudgetPart sampling = part(ModelApproximation::sampling, "fd-kf limit", "mcs", 5e-4);
      sampling.uncertainty.reset();
      sampling.expected = 6e-4;
      sampling.quantile_99 = 8e-4;
      rows.push_back({.solution = id,
                      .variable = variable,
                      .reference = "mcs",
                      .total = total,
                      .total_tail = 0,
                      .tail_from = 0,
                      .tail_to = 0,
                      .tail_bins = 0,
                      .parts = {part(ModelApproximation::closure, id, "fd-km4-delta", closure),
                                part(ModelApproximation::impact, "fd-km4-delta", "fd-km4", impact),
                                sampling}});
    }
  }
};

TEST(Limits, GroupClosuresByTheLargestPartAndByTheReference) {
  Budgets one;
  one.add("epc-gaussian-n2", 9e-3, 5e-4, 9.2e-3);
  one.add("epc-gaussian-n4", 4e-3, 5e-4, 4.2e-3, Status::inadmissible);
  one.add("epc-gaussian-n6", 1e-4, 2e-3, 2.1e-3);
  one.add("epc-gaussian-n8", 1e-4, 2e-4, 6e-4);
  one.add("epc-polar-n8", 1e-5, 2e-5, 7.9e-4);
  EXPECT_EQ(one.limits(),
            "Limiting error of each closure: the closure approximation in epc-gaussian-n2 and -n4 "
            "(inadmissible) (80 to 90 % of the sum of the parts); the impact to first order in 1-r "
            "in epc-gaussian-n6 (77 %); none above the sampling error of mcs (L1) in "
            "epc-gaussian-n8 and epc-polar-n8.");
}

TEST(Limits, RequireBothVariablesWithinTheReferenceError) {
  Budgets one;
  one.add("epc-polar-n8", 4e-4, 2e-5, 7e-4);
  EXPECT_NE(one.limits().find("none above the sampling error of mcs"), std::string::npos);
  one.rows[1].total = 8.1e-4;
  EXPECT_EQ(one.limits(),
            "Limiting error of each closure: the sampling error of the reference in epc-polar-n8 "
            "(54 % of the sum of the parts).");
}

TEST(Limits, UseTheDiscretisationErrorWithoutASimulation) {
  Budgets one;
  one.add_solution("epc-polar-n8", Status::ok);
  one.rows.push_back(
      {.solution = "epc-polar-n8",
       .variable = StateVariable::y,
       .reference = "fd-kf limit",
       .total = 2e-5,
       .total_tail = 0,
       .tail_from = 0,
       .tail_to = 0,
       .tail_bins = 0,
       .parts = {part(ModelApproximation::closure, "epc-polar-n8", "fd-kf", 4e-5),
                 part(ModelApproximation::discretisation, "fd-kf", "fd-kf limit", 3e-5)}});
  one.rows[0].parts[1].uncertainty = 3e-5;
  EXPECT_EQ(
      one.limits(),
      "Limiting error of each closure: none above the discretisation error of fd-kf limit (L1) in "
      "epc-polar-n8.");
  one.rows[0].total = 5e-5;
  EXPECT_EQ(
      one.limits(),
      "Limiting error of each closure: the closure approximation in epc-polar-n8 (57 % of the "
      "sum of the parts).");
}

TEST(Limits, ReportADisagreementOfTheReferences) {
  const auto text = [](double l1) {
    Budgets one;
    one.add("epc-polar-n8", 1e-5, 2e-5, 7e-4);
    one.add_references(l1);
    return one.limits();
  };
  // The 99 % quantile is 8e-4: slightly larger distances are no disagreement.
  for (const double l1 : {5e-4, 9e-4}) {
    EXPECT_EQ(text(l1).find("more than their errors explain"), std::string::npos) << text(l1);
    EXPECT_NE(text(l1).find("none above"), std::string::npos) << text(l1);
  }
  EXPECT_NE(text(1.1e-3).find("more than their errors explain"), std::string::npos);
  EXPECT_EQ(text(1.1e-3).find("none above"), std::string::npos);
}

TEST(Limits, AreEmptyWithoutABudget) { EXPECT_EQ(Budgets().limits(), ""); }

}  // namespace
}  // namespace fpkcheck::compare
