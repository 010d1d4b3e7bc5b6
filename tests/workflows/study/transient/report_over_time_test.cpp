#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "made_up_transient.hpp"
#include "results/opened_netcdf.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"
#include "workflows/study/transient/report_over_time.hpp"

namespace fpkcheck::study {
namespace {

namespace fs = std::filesystem;
using tests::contains;

TEST(TransientReport, WithoutGnuplotWarnsAndWritesTheScript) {
  const tests::TemporaryDirectory directory;
  const auto warnings =
      write_transient_files(directory.path(), tests::made_up_transient(), {}, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings.front(), "'no-such-gnuplot' was not found")) << warnings.front();
  EXPECT_TRUE(fs::exists(directory.path() / "transient.nc"));
  EXPECT_TRUE(fs::exists(directory.path() / "figures" / "transient-it_s_a__case_.gp"));
}

TEST(TransientReport, AFileThatCannotBeWrittenIsUnchanged) {
  const tests::TemporaryDirectory directory;
  fs::create_directories(directory.path() / "transient.nc" / "occupied");
  EXPECT_THROW(write_transient_files(directory.path(), tests::made_up_transient()),
               std::runtime_error);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"transient.nc"});
}

TEST(TransientReport, RemovesFilesOfAnEarlierRunWithoutADensity) {
  const tests::TemporaryDirectory directory;
  TransientRun run = tests::made_up_transient();
  write_transient_files(directory.path(), run);
  run.result.snapshots.clear();
  EXPECT_EQ(write_transient_files(directory.path(), run).size(), 1u);
  EXPECT_FALSE(fs::exists(directory.path() / "transient.nc"));
  EXPECT_TRUE(fs::is_empty(directory.path() / "figures"));
}

TEST(TransientReport, TableFitsEightyColumnsAndIsThinnedEvenly) {
  for (const int last : {1, 4, 24, 25, 1000}) {
    TransientRun run = tests::made_up_transient(last);
    run.result.status = transform::Status::inadmissible;
    run.result.reason = "at t = 1 the density is negative";
    run.result.snapshots.back().moments.v1 = -123.4567;
    std::istringstream lines(transient_table(run, 80));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_LE(count, 24 + 10);
    EXPECT_TRUE(contains(transient_table(run, 80), "inadmissible: at t = 1"));
  }
}

TEST(TransientJson, HasEverySnapshotAndNoInfinities) {
  TransientRun run = tests::made_up_transient();
  run.result.snapshots[2].power_residual = HUGE_VAL;
  const auto json = nlohmann::json::parse(transient_json(run));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("case").at("system").at("restitution"), 0.98);
  EXPECT_EQ(json.at("options").at("until"), 2);
  EXPECT_EQ(json.at("options").at("equation"), "kf");
  EXPECT_FALSE(json.at("options").contains("stepper"));  // for the stationary density alone
  EXPECT_EQ(json.at("start").at("ydot"), 0.25);
  ASSERT_EQ(json.at("snapshots").size(), 5u);
  EXPECT_EQ(json.at("snapshots").at(3).at("moments").at("y2"), 13);
  EXPECT_TRUE(json.at("snapshots").at(2).at("power_residual").is_null());
}

TEST(TransientNetCdf, HasTheMarginalsWithNamedAxes) {
  const tests::TemporaryDirectory directory;
  const TransientRun run = tests::made_up_transient();
  write_transient_netcdf(directory.path() / "transient.nc", run);
  const tests::OpenedNetCdf file(directory.path() / "transient.nc");

  EXPECT_EQ(file.dimensions("p_y"), (std::vector<std::string>{"time", "y"}));
  EXPECT_EQ(file.dimensions("p_ydot"), (std::vector<std::string>{"time", "ydot"}));
  EXPECT_EQ(file.dimensions("y_bounds"), (std::vector<std::string>{"y", "bounds"}));
  EXPECT_EQ(file.values("time", 5), (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(file.values("y", 4), (std::vector<double>{0.25, 0.75, 1.5, 2.5}));
  EXPECT_EQ(file.values("y_bounds", 8), (std::vector<double>{0, 0.5, 0.5, 1, 1, 2, 2, 3}));
  EXPECT_EQ(file.values("ydot", 6).front(), -2.5);
  EXPECT_EQ(file.values("p_y", 20)[4 * 3 + 2], 1.0 / 6);                // n = 3, b = 2
  EXPECT_EQ(file.values("p_ydot", 30)[6 * 4 + 5], 0.1 * 5 + 0.01 * 4);  // n = 4, b = 5
  EXPECT_EQ(file.values("y2", 5), (std::vector<double>{10, 11, 12, 13, 14}));

  for (const char* variable : {"time", "y", "ydot", "p_y", "p_ydot", "y2", "energy"}) {
    EXPECT_EQ(file.text(variable, "units"), "1");
    EXPECT_FALSE(file.text(variable, "long_name").empty());
  }
  EXPECT_EQ(file.text("ydot", "bounds"), "ydot_bounds");
  EXPECT_EQ(file.text(nullptr, "Conventions"), "CF-1.8");
  EXPECT_EQ(file.text(nullptr, "command"), "fpkcheck fd it's --until 2");
  EXPECT_EQ(file.text(nullptr, "impulse_law"), "gaussian");
  EXPECT_EQ(file.number("restitution"), 0.98);
}

}  // namespace
}  // namespace fpkcheck::study
