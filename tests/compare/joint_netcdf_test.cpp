#include "compare/joint_netcdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "compare/report.hpp"
#include "compare/run_directory.hpp"
#include "opened_netcdf.hpp"
#include "problem/input_error.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;

// Two cases with cells of their own, numbers that can be told apart, and "b" in the first case
// only.
SavedRun small_run() {
  SavedRun run = tests::made_up_run("it's a-1");
  auto& cases = run.summary["cases"];
  cases.push_back(cases[0]);
  cases[1]["name"] = "case2";
  cases[1]["system"]["restitution"] = 0.5;
  for (auto& one : cases) {
    one["solutions"] = {{{"id", "a"}}, {{"id", "none"}}, {{"id", "b"}}};
  }
  run.joints = {{"it's a-1", "a", {{0, 1, 3}, {-2, 0, 1, 2}, {1, 2, 3, 4, 5, 6}}},
                {"it's a-1", "b", {{0, 1, 3}, {-2, 0, 1, 2}, {-1, 0, 0.5, 1e-30, 7, 8}}},
                {"case2", "a", {{0, 5}, {-1, 0, 1}, {0.25, 0.75}}}};
  return run;
}

void expect_same(const std::vector<JointDensity>& read, const std::vector<JointDensity>& written) {
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    EXPECT_EQ(read[k].case_name, written[k].case_name);
    EXPECT_EQ(read[k].solution, written[k].solution);
    EXPECT_EQ(read[k].density.y_edges, written[k].density.y_edges);
    EXPECT_EQ(read[k].density.v_edges, written[k].density.v_edges);
    ASSERT_EQ(read[k].density.averages.size(), written[k].density.averages.size());
    for (std::size_t n = 0; n < read[k].density.averages.size(); ++n) {
      EXPECT_FLOAT_EQ(static_cast<float>(read[k].density.averages[n]),
                      static_cast<float>(written[k].density.averages[n]));
    }
  }
}

TEST(JointNetCdf, HoldsTheDensitiesWithNamedAxesAndWhatTheyAreOf) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = small_run();
  write_joint_netcdf(directory.path() / "joint.nc", run.summary, run.joints);
  const tests::OpenedNetCdf file(directory.path() / "joint.nc");

  EXPECT_EQ(file.dimensions("p_case2"),
            (std::vector<std::string>{"solution", "y_case2", "ydot_case2"}));
  EXPECT_EQ(file.dimensions("y_it_s_a-1"), std::vector<std::string>{"y_it_s_a-1"});
  EXPECT_EQ(file.values("y_it_s_a-1", 2), (std::vector<double>{0.5, 2}));
  EXPECT_EQ(file.values("ydot_it_s_a-1_bounds", 6), (std::vector<double>{-2, 0, 0, 1, 1, 2}));
  const auto p = file.values("p_it_s_a-1", 18);
  EXPECT_EQ(p[5], 6);   // of a: y in (1, 3), y' in (1, 2)
  EXPECT_EQ(p[16], 7);  // of b: y in (1, 3), y' in (0, 1)
  EXPECT_TRUE(std::isnan(p[6]) && std::isnan(p[11]));
  EXPECT_TRUE(std::isnan(file.values("p_case2", 6)[5]));

  EXPECT_EQ(file.text("p_it_s_a-1", "case"), "it's a-1");
  EXPECT_EQ(file.text("ydot_case2", "units"), "1");
  EXPECT_EQ(file.text("ydot_case2", "bounds"), "ydot_case2_bounds");
  EXPECT_EQ(file.text("p_case2", "impulse_law"), "gaussian");
  EXPECT_EQ(file.number("restitution", "p_case2"), 0.5);
  EXPECT_EQ(file.number("restitution", "p_it_s_a-1"), 0.98);
  EXPECT_EQ(file.text(nullptr, "Conventions"), "CF-1.8");
  EXPECT_EQ(file.text(nullptr, "command"), "fpkcheck run");
}

TEST(JointNetCdf, IsReadBack) {
  const tests::TemporaryDirectory directory;
  const fs::path file = directory.path() / "joint.nc";
  const SavedRun run = small_run();
  write_joint_netcdf(file, run.summary, run.joints);
  expect_same(read_joint_netcdf(file), run.joints);
}

TEST(JointNetCdf, ThatIsBrokenIsRefusedInOneLine) {
  const tests::TemporaryDirectory directory;
  const fs::path file = directory.path() / "joint.nc";
  const SavedRun run = small_run();
  write_joint_netcdf(file, run.summary, run.joints);
  const std::string whole = contents(file);
  for (const std::string& broken :
       {std::string(), std::string("not netCDF"), whole.substr(0, whole.size() / 2)}) {
    write_file(file, broken);
    try {
      read_joint_netcdf(file);
      ADD_FAILURE() << "accepted " << broken.size() << " bytes of " << whole.size();
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), file.string())) << error.what();
      EXPECT_FALSE(contains(error.what(), "\n")) << error.what();
    }
  }
}

TEST(JointNetCdf, IsPartOfASavedRun) {
  const tests::TemporaryDirectory directory;
  const SavedRun run = tests::made_up_run();
  write_report(directory.path(), run);
  expect_same(load_run(directory.path()).joints, run.joints);
  EXPECT_NO_THROW(report_again(directory.path()));

  // A run of an older version.
  fs::remove(directory.path() / "joint.nc");
  EXPECT_TRUE(load_run(directory.path()).joints.empty());
  EXPECT_NO_THROW(report_again(directory.path()));

  const SavedRun other = small_run();
  write_joint_netcdf(directory.path() / "joint.nc", other.summary, other.joints);
  EXPECT_THROW(report_again(directory.path()), InputError);

  SavedRun without = run;
  without.joints.clear();
  write_report(directory.path(), without);
  EXPECT_FALSE(fs::exists(directory.path() / "joint.nc"));
}

}  // namespace
}  // namespace fpkcheck::compare
