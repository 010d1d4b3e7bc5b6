#include "workflows/paper/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "epc/options.hpp"
#include "methods/builtin_solvers.hpp"
#include "problem/case_file.hpp"
#include "workflows/paper/claim_criteria.hpp"

namespace fpkcheck::paper {
namespace {

TEST(Claims, CoverEveryPanelAndBothDensitiesOfEveryCase) {
  std::set<std::string> panels;
  std::set<std::pair<int, transform::StateVariable>> densities;
  for (const auto& claim : paper_claims()) {
    if (claim.cases.size() > 1) continue;
    for (const char panel : claim.panels) {
      panels.insert(std::to_string(PaperClaim::figure_number(claim.cases.front())) + panel);
    }
    for (const auto variable : claim.variables) densities.insert({claim.cases.front(), variable});
  }
  EXPECT_EQ(panels.size(), 16u);
  EXPECT_TRUE(panels.contains("2a"));
  EXPECT_TRUE(panels.contains("5d"));
  EXPECT_EQ(densities.size(), 8u);
}

TEST(Claims, CoverEachOrderInEachCase) {
  for (int number = 1; number <= 4; ++number) {
    for (const int order : {2, 4, 6, 8}) {
      EXPECT_TRUE(std::ranges::any_of(paper_claims(),
                                      [&](const PaperClaim& claim) {
                                        return claim.cases == std::vector<int>{number} &&
                                               claim.order == order;
                                      }))
          << number << ' ' << order;
    }
  }
}

TEST(Claims, AreUniqueByCaseAndTextAndHaveQuotations) {
  std::set<std::pair<std::vector<int>, std::string>> seen;
  for (const auto& claim : paper_claims()) {
    EXPECT_TRUE(seen.insert({claim.cases, claim_text(claim)}).second) << claim_text(claim);
    EXPECT_FALSE(claim.quote.empty());
    EXPECT_EQ(claim.panels.find_first_not_of("abcd"), std::string::npos);
    // Each panel shows one of the two densities.
    for (const auto variable : claim.variables) {
      const bool is_y = variable == transform::StateVariable::y;
      if (claim.panels.empty()) continue;
      EXPECT_NE(claim.panels.find_first_of(is_y ? "ab" : "cd"), std::string::npos)
          << claim_text(claim);
    }
    const bool compares = claim.relation == PaperClaimRelation::closer ||
                          claim.relation == PaperClaimRelation::closer_in_l1 ||
                          claim.relation == PaperClaimRelation::closer_in_tail;
    EXPECT_EQ(compares, claim.rival != 0) << claim_text(claim);
  }
}

TEST(Claims, ReferToExistingMethodsAndCases) {
  const auto methods = methods::builtin_registry().methods_selected_by_list(kRequiredMethods, {});
  for (const auto& claim : paper_claims()) {
    EXPECT_TRUE(std::ranges::any_of(methods, [&](const methods::Method& method) {
      return method.identity.id == paper_closure_id(claim.order);
    })) << claim_text(claim);
  }
  ASSERT_EQ(problem::paper_cases().size(), 4u);
  for (int number = 1; number <= 4; ++number) {
    EXPECT_EQ(problem::paper_cases()[static_cast<std::size_t>(number) - 1].name,
              paper_case_name(number));
  }
}

TEST(Criteria, AgreementIsTheDefaultAccuracyOfClosures) {
  EXPECT_EQ(epc::ClosureOptions{}.accuracy, kMaxL1OfClaimedAgreement);
}

}  // namespace
}  // namespace fpkcheck::paper
