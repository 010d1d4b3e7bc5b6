#include "workflows/sweep/report/sweep_files.hpp"

#include <gtest/gtest.h>

#include "base/files/file_transaction.hpp"
#include "made_up_sweep.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

TEST(SweepFiles, TablesReplaceEarlierFiles) {
  const tests::TemporaryDirectory directory;
  base::write_file_atomically(directory.path() / "report.html", "of other numbers");
  base::write_file_atomically(directory.path() / "sweep.csv", "other numbers");
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  write_sweep_tables(directory.path(), results, "fpkcheck sweep");
  EXPECT_EQ(tests::contents(directory.path() / "sweep.csv"), sweep_csv_text(results));
  EXPECT_TRUE(exists(directory.path() / "sweep.nc"));
  EXPECT_FALSE(exists(directory.path() / "report.html"));
}

TEST(SweepFiles, WithoutGnuplotThePageHasNoPictures) {
  const tests::TemporaryDirectory directory;
  const auto warnings = write_report(directory.path(), tests::made_up_sweep({tests::kTwoLaws}),
                                     "fpkcheck sweep", {}, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  const std::string page = tests::contents(directory.path() / "report.html");
  EXPECT_FALSE(contains(page, "<img"));
  EXPECT_FALSE(contains(page, "Pictures"));
  EXPECT_TRUE(contains(page, "epc-moment-n4"));
}

TEST(SweepFiles, PagesHavePicturesAsSvg) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = write_report(directory.path(), tests::made_up_sweep({tests::kTwoLaws}), "");
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  const std::string page = tests::contents(directory.path() / "report.html");
  const auto first = page.find("<img");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(page.find("<img", first + 1), std::string::npos);
  EXPECT_TRUE(contains(page, "data:image/svg+xml"));
}

TEST(SweepFiles, PagesOfManyPointsStaySmall) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  constexpr std::uintmax_t kLargest = 1'500'000;
  for (const auto design : {SweepPlanDesign::product, SweepPlanDesign::sobol}) {
    const bool is_product = design == SweepPlanDesign::product;
    const tests::TemporaryDirectory directory;
    const auto plan =
        is_product
            ? tests::made_up_plan(
                  {{"system.restitution", "0.5:1:100"}, {"impulse.rate", "log:0.1:10:100"}})
            : tests::made_up_plan({{"system.restitution", "0.5:1"}, {"impulse.rate", "log:0.1:10"}},
                                  design, 10000);
    const auto warnings = write_report(directory.path(), tests::made_up_sweep(plan), "");
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_LT(file_size(directory.path() / "report.html"), kLargest);
    EXPECT_EQ(contains(tests::contents(directory.path() / "report.html"), "data:image/png"),
              !is_product);
  }
}

}  // namespace
}  // namespace fpkcheck::sweep
