#include <gtest/gtest.h>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(GridTable, ShowsGridsLimitsOtherMethodsAndTheFastest) {
  const std::string text = tests::in_one_line(table(tests::made_up_grid_study(), 100));
  for (const char* expected :
       {"finite volumes for kf, impact map", "3 30 x 60 ok 3.7e-03 7.4e-03 2.8 7.0 - 900",
        "3 10 x 20 inadmissible", "5 0.39451776 1e-06 0.4415 2e-06 0 0 0.0e+00 1.4e-04",
        "epc-gaussian-n2 ok 4.4e-03 3.0e-02 6.7", "epc-gaussian-n4 inadmissible - - 2.0",
        "order 3 on 10 x 20 cells inadmissible: it is made up",
        "epc-gaussian-n4 inadmissible: it is made up",
        "The limit is that of order 5; the limit of the next lower order differs by L1 1.2e-04 in "
        "p(y) and 1.4e-04 in p(y')",
        "Fastest to L1 1e-02 in both marginals: epc-moment-n4 in 30 ms; finite volumes of "
        "order 3 on 30 x 60 cells in 900 ms; mcs in 2000 ms.",
        "Fastest to L1 1e-03 in both marginals: epc-moment-n4 in 30 ms.",
        "observed order: from the differences of the last three levels."}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
  EXPECT_EQ(text.find("Fastest to L1 1e-04"), std::string::npos) << text;
}

TEST(GridTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    EXPECT_LE(tests::longest_line(table(tests::made_up_grid_study(), width)), width);
  }
}

TEST(GridTable, HasTheReasonWithoutALimit) {
  auto study = tests::made_up_grid_study();
  study.limits.back() = {.order = 5, .failure = "nothing converges"};
  study.others.clear();
  const std::string text = table(study, 100);
  EXPECT_NE(text.find("There is no limit at the highest order: nothing converges."),
            std::string::npos);
  EXPECT_EQ(text.find("other methods"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::study
