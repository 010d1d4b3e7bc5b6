#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "solved_run.hpp"
#include "workflows/check/check.hpp"

namespace fpkcheck::check {
namespace {

using tests::paper_baseline;
using tests::scale;
using tests::solution;
using tests::solved_run;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CheckTable, ListsTheChangesAndEndsWithASentence) {
  auto changed = solved_run();
  scale(solution(changed, "epc-moment-n8").moments.y2, 1e-6);
  solution(changed, "fd-kf").status = transform::Status::failed;
  const auto two = check(paper_baseline(), changed, {});
  for (const std::size_t width : {80u, 100u}) {
    const std::string text = check_table(two, width);
    for (const char* part : {"epc-moment-n8", "E[y^2]", "0.39453765", "1e-06", "failed"}) {
      EXPECT_TRUE(contains(text, part)) << part << " not in:\n" << text;
    }
    EXPECT_TRUE(contains(text, fmt::format("2 of {} figures of", two.changes.size()))) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), width) << line;
  }
}

TEST(CheckTable, HasARowForEveryKindAndTheNotes) {
  auto same = check(paper_baseline(), solved_run(), {});
  same.notes = {"The curves were drawn by hand."};
  const std::string text = check_table(same, 100);
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
  const auto all = check(paper_baseline(), changed, {});
  ASSERT_GT(all.changed_quantities().size(), 50u);
  const std::string text = check_table(all, 100);
  EXPECT_LT(std::ranges::count(text, '\n'), 65);
  EXPECT_TRUE(contains(text, "failed"));
  EXPECT_TRUE(contains(text, fmt::format("and {} more", all.changed_quantities().size() - 40)));
}

}  // namespace
}  // namespace fpkcheck::check
