#include "workflows/paper/claims_supplement.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "judged_run.hpp"
#include "results/run_json.hpp"

namespace fpkcheck::paper {
namespace {

// Number of fields: commas outside quotes, plus 1.
std::size_t fields(const std::string& line) {
  std::size_t count = 1;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++count;
  }
  return count;
}

TEST(ClaimsFiles, CsvHasACompleteRowForEveryClaim) {
  std::istringstream lines(claims_csv(judge_claims(tests::run_with_distances(0.0123, 0.1))));
  std::string line;
  std::getline(lines, line);
  const auto columns = fields(line);
  EXPECT_EQ(line.substr(0, 23), "case,figure,claim,n,den");
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows) EXPECT_EQ(fields(line), columns) << line;
  EXPECT_EQ(rows, paper_claims().size());
  EXPECT_NE(claims_csv(judge_claims(tests::run_with_distances(0.0123, 0.1)))
                .find("\n1,2ab,n=6 agrees with MCS in p(y),6,y,agrees,,0.0123,<= 0.02,0.1,<= "
                      "0.2,ok,established,,"),
            std::string::npos);
}

TEST(ClaimsFiles, JsonHasTheNumbersTheOutcomeAndThePapersWords) {
  const auto run = tests::run_with_distances(0.03, 0.1);
  const auto json = nlohmann::json::parse(claims_json(judge_claims(run), run.program));
  ASSERT_EQ(json.at("claims").size(), paper_claims().size());
  EXPECT_EQ(json.at("criteria").at("agreement_l1"), 0.02);
  EXPECT_EQ(json.at("program").at("name"), "fpkcheck");
  const auto& differs = json.at("claims").at(5);
  EXPECT_EQ(differs.at("claim"), "n=2 differs from MCS in p(y')");
  EXPECT_EQ(differs.at("cases"), nlohmann::json({1}));
  EXPECT_EQ(differs.at("figures"), nlohmann::json({2}));
  EXPECT_EQ(differs.at("variables"), nlohmann::json({"ydot"}));
  EXPECT_EQ(differs.at("l1").at("value"), 0.03);
  EXPECT_EQ(differs.at("l1").at("wanted").at("above"), 0.02);
  EXPECT_EQ(differs.at("outcome"), "established");
  EXPECT_NE(differs.at("quote").get<std::string>().find("differ significantly"), std::string::npos);
  const auto& eighth = json.at("claims").at(7);
  EXPECT_TRUE(eighth.at("l1").at("value").is_null());
  EXPECT_EQ(eighth.at("status"), "not_converged");
}

TEST(ClaimsFiles, TheSummaryWithClaimsCanBeReadAsASummary) {
  const auto run = tests::run_with_distances();
  const std::string text = summary_json_with_claims(judge_claims(run), run);
  EXPECT_EQ(nlohmann::json::parse(text).at("claims").size(), paper_claims().size());
  std::istringstream in(text);
  EXPECT_EQ(results::read_run_summary(in, "it").cases.size(), 4u);
}

}  // namespace
}  // namespace fpkcheck::paper
