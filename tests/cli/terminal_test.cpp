#include "cli/terminal.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::cli {
namespace {

methods::RunProgress at(double fraction, const std::string& note = "") {
  return {.done = 3,
          .total = 8,
          .case_name = "case1",
          .method = "mcs",
          .fraction = fraction,
          .note = note};
}

TEST(ProgressText, EstimatesTheRemainingTimeOfAMethod) {
  // A quarter took 10 s: 30 s remain, independent of the elapsed time of the run.
  EXPECT_EQ(progress_text(at(0.25, "error 1e-03"), 50, 10),
            "[3/8] 50 s  case1 mcs 25 %, 30 s left  error 1e-03");
  EXPECT_EQ(progress_text(at(0.1), 50, 60), "[3/8] 50 s  case1 mcs 10 %, 9 min left");
}

TEST(ProgressText, OmitsUnknownValues) {
  EXPECT_EQ(progress_text(at(0), 50, 10), "[3/8] 50 s  case1 mcs");
  EXPECT_EQ(progress_text(at(0.01), 50, 10), "[3/8] 50 s  case1 mcs 1 %");
  EXPECT_EQ(progress_text(at(1), 250, 10), "[3/8] 4 min  case1 mcs");
}

}  // namespace
}  // namespace fpkcheck::cli
