#include <fmt/format.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "saved_run.hpp"
#include "solved_run.hpp"
#include "workflows/check/compare_runs.hpp"

namespace fpkcheck::check {
namespace {

TEST(CheckJson, HasEveryChangeAndEveryKind) {
  auto changed = tests::solved_run();
  tests::scale(tests::solution(changed, "epc-moment-n8").moments.y2, 1e-6);
  tests::solution(changed, "fd-kf").status = transform::Status::failed;
  const auto two = compare_runs(tests::paper_baseline(), changed, {});
  const auto json = nlohmann::json::parse(check_result_json(two, "fpkcheck check b", "b"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["program"]["command"], "fpkcheck check b");
  EXPECT_EQ(json["baseline"], "b");
  EXPECT_EQ(json["agrees"], false);
  EXPECT_EQ(json["figures"], two.changes.size());
  EXPECT_EQ(json["solutions"], 9);
  ASSERT_EQ(json["moved"].size(), 2u);
  const auto& moment = json["moved"][0];
  EXPECT_EQ(moment["case"], "case1");
  EXPECT_EQ(moment["figure"], "E[y^2]");
  EXPECT_NEAR(moment["change"].get<double>(), 1e-6, 1e-12);
  EXPECT_EQ(json["moved"][1]["now"], "failed");
  EXPECT_TRUE(json["moved"][1]["change"].is_null());  // JSON has no infinity
  EXPECT_EQ(json["kinds"].size(), std::size(kQuantityKindNames));
}

using tests::contains;
using tests::paper_baseline;
using tests::scale;
using tests::solution;
using tests::solved_run;

TEST(CheckTable, ListsTheChangesAndEndsWithASentence) {
  auto changed = solved_run();
  scale(solution(changed, "epc-moment-n8").moments.y2, 1e-6);
  solution(changed, "fd-kf").status = transform::Status::failed;
  const auto two = compare_runs(paper_baseline(), changed, {});
  for (const std::size_t width : {80u, 100u}) {
    const std::string text = check_result_table(two, width);
    for (const char* part : {"epc-moment-n8", "E[y^2]", "0.39453765", "1e-06", "failed"}) {
      EXPECT_TRUE(contains(text, part)) << part << " not in:\n" << text;
    }
    EXPECT_TRUE(contains(text, fmt::format("2 of {} figures of", two.changes.size()))) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), width) << line;
  }
}

TEST(CheckTable, HasARowForEveryKindAndTheNotes) {
  auto same = compare_runs(paper_baseline(), solved_run(), {});
  same.notes = {"The curves were drawn by hand."};
  const std::string text = check_result_table(same, 100);
  for (const auto& entry : kQuantityKindNames) {
    EXPECT_TRUE(contains(text, std::string(entry.name))) << entry.name;
  }
  EXPECT_TRUE(contains(text, "The curves were drawn by hand."));
  EXPECT_TRUE(contains(text, fmt::format("{} figures of {} solutions agree.\n", same.changes.size(),
                                         same.solutions)));
}

TEST(CheckTable, ShowsTheLargestChangesAlone) {
  auto changed = solved_run();
  for (auto& pair : changed.cases[0].pairs) scale(pair.distances.l1, 0.3);
  solution(changed, "fd-kf").status = transform::Status::failed;
  const auto all = compare_runs(paper_baseline(), changed, {});
  ASSERT_GT(all.quantities_beyond_tolerance().size(), 50u);
  const std::string text = check_result_table(all, 100);
  EXPECT_LT(std::ranges::count(text, '\n'), 65);
  EXPECT_TRUE(contains(text, "failed"));
  EXPECT_TRUE(
      contains(text, fmt::format("and {} more", all.quantities_beyond_tolerance().size() - 40)));
}

}  // namespace
}  // namespace fpkcheck::check
