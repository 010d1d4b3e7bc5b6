#include <gtest/gtest.h>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(RegularisationTable, ReportsWhichSchemesGrowAndWhichDecay) {
  const std::string text = tests::in_one_line(table(tests::made_up_regularisation_study(), 100));
  for (const char* expected :
       {"literal 0.1 0.1 16x60 352 30 320 - x10 in 0.0072 4.10000 2.30000 -5e-01",
        "literal 0.4 0.4 16x60 0 - -1e-15 -0.119+-2.1i settles 0.00030 0.00040 -1e-07",
        "pade 0.2 - 16x60 - - - - - - - -", "pade at h = 0.2: there is none",
        "grows at h = 0.2 and 0.1, in the end as h^-4.00", "up to L1 2.3 from kf",
        "falls to -0.47 of its peak", "default length l = 0.4 grows on no step",
        "L1 0.0003 in p(y) and 0.0004 in p(y')", "threshold is l* = 0.3",
        "10 % below it the matrices of h = 0.1 grow", "10 % above it no matrix grows"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
}

TEST(RegularisationTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    EXPECT_LE(tests::longest_line(table(tests::made_up_regularisation_study(), width)), width);
  }
}

}  // namespace
}  // namespace fpkcheck::study
