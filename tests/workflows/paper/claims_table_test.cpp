#include "workflows/paper/claims_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "judged_run.hpp"

namespace fpkcheck::paper {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(ClaimsTable, HasARowForEveryClaimWithinTheWidth) {
  const auto judgements = judge_claims(tests::run_with_distances());
  for (const std::size_t width : {80u, 100u}) {
    const std::string text = claims_table_text(judgements, width);
    std::istringstream lines(text);
    std::size_t rows = 0;
    bool notes = false;
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), width) << line;
      notes = notes || line.starts_with("  case ");
      rows += !notes && line.find_first_of("1234") == 0;
    }
    EXPECT_EQ(rows, paper_claims().size()) << text;
  }
}

TEST(ClaimsTable, ShowsTheNumbersAndTheirLimits) {
  const std::string text =
      claims_table_text(judge_claims(tests::run_with_distances(0.0123, 0.1)), 100);
  EXPECT_NE(text.find("1    2ab  n=6 agrees with MCS in p(y)           0.01230 <= 0.02    0.100 <= "
                      "0.2   established\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("0.01230 > 0.02     0.100 or > 0.2 not established\n"), std::string::npos)
      << text;
}

TEST(ClaimsTable, QuotesTheReasonOfAClosureOncePerCase) {
  auto run = tests::run_with_distances();
  tests::closure(run, 4, 4).reason = "why it is none";
  const std::string text = claims_table_text(judge_claims(run), 100);
  EXPECT_EQ(count(text, "why it is none"), 1u) << text;
  EXPECT_GT(count(text, "case 4, n=4 agrees"), 2u) << text;
}

TEST(ClaimsTable, ClosesWithTheNumberOfEachOutcome) {
  std::vector<PaperClaimJudgement> three(3);
  three[0].outcome = PaperClaimOutcome::established;
  three[1].outcome = PaperClaimOutcome::not_established;
  EXPECT_EQ(
      claim_count_sentence(three),
      "3 claims of the paper: 1 established (the run's numbers are as the claim states); 1 not "
      "established (the numbers are not as the claim states); 1 unjudged (a number that "
      "decides the claim is missing).");
}

// Lists each claim that is not simply established once, with the cases of its outcome.
TEST(ClaimsTable, SummaryListsTheClaimsOfEachOtherOutcome) {
  const auto judgements = judge_claims(tests::run_with_distances());
  const auto sentences = claim_outcome_summary(judgements);
  EXPECT_EQ(sentences.front(), claim_count_sentence(judgements));
  std::set<PaperClaimOutcome> outcomes;
  for (const auto& one : judgements) {
    if (one.outcome == PaperClaimOutcome::established) continue;
    outcomes.insert(one.outcome);
    const std::string begin = std::string(name(one.outcome)).substr(1) + ": ";
    const auto own = std::ranges::find_if(sentences, [&](const std::string& sentence) {
      return sentence.substr(1).starts_with(begin);
    });
    ASSERT_NE(own, sentences.end()) << begin;
    EXPECT_EQ(count(*own, claim_text(one.claim) + " (case "), 1u) << *own;
  }
  EXPECT_EQ(sentences.size(), 1 + outcomes.size());
}

}  // namespace
}  // namespace fpkcheck::paper
