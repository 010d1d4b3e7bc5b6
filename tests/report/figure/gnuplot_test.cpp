#include "report/figure/gnuplot.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "report/figure/figure_layout.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;
using tests::gnuplot_exists;

TEST(GnuplotString, QuotesAndEscapes) {
  EXPECT_EQ(quote_for_gnuplot("it's"), "'it''s'");
  // A string ends with its line: gnuplot would run the next line as a command.
  EXPECT_EQ(quote_for_gnuplot("x'\nsystem(\"rm\")\r#\x1b"), "'x'' system(\"rm\") # '");
  EXPECT_EQ(escape_enhanced_text("a_b^{c}"), "a\\_b\\^\\{c\\}");
}

/// A directory with a program that prints its arguments and its environment.
class Gnuplot : public testing::Test {
 protected:
  Gnuplot() {
    std::ofstream(program_) << "#!/bin/sh\nfor a; do echo \"$a\"; done\nenv\n";
    fs::permissions(program_, fs::perms::owner_all);
  }
  tests::TemporaryDirectory directory_;
  fs::path program_ = directory_.path() / "says";
};

TEST_F(Gnuplot, GetsAnAbsolutePathAndNoUserSettings) {
  setenv("GNUTERM", "dumb", 1);
  const auto outcome = run_gnuplot(program_, {"format='png'"}, "<touch PWNED;#");
  unsetenv("GNUTERM");
  EXPECT_TRUE(outcome.message.starts_with("-d\n-e\nformat='png'; \n/")) << outcome.message;
  EXPECT_TRUE(contains(outcome.message, "/<touch PWNED;#\n"));
  EXPECT_FALSE(contains(outcome.message, "GNUTERM")) << outcome.message;
  EXPECT_TRUE(contains(outcome.message, "PATH="));
}

TEST_F(Gnuplot, IsReportedAsNotFound) {
  EXPECT_FALSE(run_gnuplot("no-such-gnuplot", {}, "script").found);
  EXPECT_TRUE(run_gnuplot("false", {}, "script").found);
  EXPECT_EQ(run_gnuplot("false", {}, "script").exit_code, 1);
}

TEST_F(Gnuplot, IsKilledAfterTheTimeLimit) {
  using namespace std::chrono_literals;
  std::ofstream(program_) << "#!/bin/sh\nexec sleep 100\n";
  const auto silent = run_gnuplot(program_, {}, "script", 200ms);
  EXPECT_EQ(silent.exit_code, -1);
  EXPECT_EQ(silent.message, "time limit of 0.2 s exceeded");
  std::ofstream(program_) << "#!/bin/sh\nexec yes\n";
  EXPECT_EQ(run_gnuplot(program_, {}, "script", 200ms).message, "time limit of 0.2 s exceeded");
}

TEST_F(Gnuplot, IsKilledAfterClosingItsOutput) {
  using namespace std::chrono_literals;
  std::ofstream(program_) << "#!/bin/sh\nexec sleep 20 >&- 2>&-\n";
  const auto begin = std::chrono::steady_clock::now();
  const auto silent = run_gnuplot(program_, {}, "script", 200ms);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
  EXPECT_EQ(silent.exit_code, -1);
  EXPECT_EQ(silent.message, "time limit of 0.2 s exceeded");
}

TEST_F(Gnuplot, HasTruncatedOutputAndEmptyInput) {
  std::ofstream(program_) << "#!/bin/sh\ncat\nhead -c 1000000 /dev/zero\n";
  const auto outcome = run_gnuplot(program_, {}, "script");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.message.size(), 10000u);
}

TEST_F(Gnuplot, RefusesAFormatThatAScriptDoesNotDraw) {
  if (!gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const fs::path script = directory_.path() / "stem.gp", target = directory_.path() / "picture";
  std::ofstream(script) << gnuplot_output_commands("stem", {.width = 300, .height = 200})
                        << "plot x\n";
  const auto drawn_as = [&](const std::string& format) {
    return run_gnuplot(
        "gnuplot",
        {"format=" + quote_for_gnuplot(format), "target=" + quote_for_gnuplot(target.string())},
        script);
  };
  const auto refused = drawn_as("gif");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_TRUE(contains(refused.message, "format = 'gif' (must be png, svg, pdf or tex)"))
      << refused.message;
  EXPECT_FALSE(fs::exists(target));
  EXPECT_EQ(drawn_as("png").exit_code, 0);
  EXPECT_TRUE(contents(target).starts_with("\x89PNG"));
  EXPECT_EQ(drawn_as("pdf").exit_code, 0);
  EXPECT_TRUE(contents(target).starts_with("%PDF"));
  EXPECT_EQ(drawn_as("svg").exit_code, 0);
  EXPECT_TRUE(contains(contents(target), "<svg"));
}

}  // namespace
}  // namespace fpkcheck::report
