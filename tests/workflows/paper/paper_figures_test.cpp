#include "workflows/paper/claims_supplement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "judged_run.hpp"

namespace fpkcheck::paper {
namespace {

bool has(const report::PictureGnuplotScript& figure, const std::string& part) {
  return figure.script.find(part) != std::string::npos;
}

TEST(PaperFigures, AreFigs2To5WithThePapersNames) {
  const auto all = paper_figure_scripts(tests::run_with_distances());
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all.front().stem, "paper-fig-2");
  EXPECT_EQ(all.back().stem, "paper-fig-5");
  EXPECT_TRUE(has(all.back(), "Fig. 5 (case4)"));
  for (const auto& figure : all) {
    for (const char* part :
         {"EPC (n = 2)", "EPC (n = 4) (inadmissible)", "EPC (n = 6)", "MCS", "(a) displacement",
          "(b) displacement, logarithmic", "(c) velocity", "(d) velocity, logarithmic"}) {
      EXPECT_TRUE(has(figure, part)) << part;
    }
    for (const char* part :
         {"(n = 8)", "fd-kf", "epc-gaussian", ", difference from", "|difference from", "Δ"}) {
      EXPECT_FALSE(has(figure, part)) << part;
    }
  }
}

TEST(PaperFigures, CoverThePeaksOfClosuresThatAreNotOk) {
  auto run = tests::run_with_distances();
  const auto before = paper_figure_scripts(run).front().script;
  tests::closure(run, 1, 2).status = transform::Status::inaccurate;
  for (auto& curve : tests::case_in(run, 1).curves) {
    if (curve.solution == "epc-gaussian-n2") curve.density.front() = 77;
  }
  EXPECT_NE(paper_figure_scripts(run).front().script.find("set yrange [0:83.16]"),
            std::string::npos);
}

TEST(PaperFigures, LeaveOutMissingSolutions) {
  auto run = tests::run_with_distances();
  run.cases.erase(run.cases.begin());
  std::erase_if(tests::case_in(run, 1).curves,
                [](const auto& curve) { return curve.solution == "mcs"; });
  const auto all = paper_figure_scripts(run);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.front().stem, "paper-fig-3");
  EXPECT_FALSE(has(all.front(), "MCS"));
}

}  // namespace
}  // namespace fpkcheck::paper
