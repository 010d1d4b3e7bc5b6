
#include <gtest/gtest.h>

#include "modified_case.hpp"
#include "report/findings.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;
using tests::solution_of;

/// Bounds centred at the moments of fd-kf.
results::CaseResult bounded_case(double half_width = 1e-4) {
  auto case_result = made_up_case();
  const auto& m = case_result.find("fd-kf")->moments;
  case_result.bounds =
      compare::GuaranteedBounds{.seconds = 0.5,
                                .each = {{"E[y^2]", m.y2 - half_width, m.y2 + half_width},
                                         {"E[y'^2]", m.v2 - half_width, m.v2 + half_width}}};
  return case_result;
}

TEST(BoundsFindings, ComeFirstAndNameApproximationsOutside) {
  auto case_result = bounded_case();
  solution_of(case_result, "fd-white").moments.y2 += 0.01;
  solution_of(case_result, "fd-white").moments.v2 += 0.01;
  const auto all = case_finding_sentences(case_result);
  EXPECT_TRUE(all.at(0).starts_with("Guaranteed bounds: E[y^2] in [")) << all[0];
  EXPECT_TRUE(contains(all[0], "fd-white")) << all[0];
  EXPECT_EQ(all[0].find("fd-white"), all[0].rfind("fd-white"));
  EXPECT_FALSE(contains(all[0], "fd-kf")) << all[0];
}

TEST(BoundsFindings, CallASolutionWrongOutsideItsStatedError) {
  auto case_result = bounded_case();
  auto& kf = solution_of(case_result, "fd-kf");
  kf.moments.y2 += 3e-4;
  kf.error.emplace().moments.y2 = 1e-4;
  EXPECT_TRUE(case_finding_sentences(case_result)
                  .at(0)
                  .starts_with("OUTSIDE THE BOUNDS: fd-kf (full problem"));
  kf.error->moments.y2 = 3e-4;
  EXPECT_FALSE(contains(case_finding_sentences(case_result).at(0), "OUTSIDE"));
}

TEST(BoundsFindings, StateTheReasonWithoutBounds) {
  auto case_result = made_up_case();
  EXPECT_TRUE(guaranteed_bounds_findings(case_result).empty());
  case_result.bounds = compare::GuaranteedBounds{.reason = "c^2 >= 4 k"};
  EXPECT_EQ(guaranteed_bounds_findings(case_result).at(0),
            "There are no guaranteed bounds: c^2 >= 4 k.");
}

TEST(BoundsTable, HasARowForEachBound) {
  const auto case_result = bounded_case();
  const std::string text = guaranteed_bounds_table(case_result.problem, *case_result.bounds, 80);
  EXPECT_TRUE(contains(text, "functional")) << text;
  EXPECT_TRUE(contains(text, "\nE[y'^2]")) << text;
  EXPECT_TRUE(contains(text, "1.0e-04")) << text;
}

}  // namespace
}  // namespace fpkcheck::report
