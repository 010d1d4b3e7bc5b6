#include "results/joint_netcdf.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "opened_netcdf.hpp"
#include "parameters/input_error.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;

transform::Solution named(const std::string& id) { return {.identity = {.id = id, .method = "m"}}; }

// Two cases with cells of their own, numbers that can be told apart, and "b" in the first case
// only.
results::Run small_run() {
  results::Run run{this_program("fpkcheck run"), {}};
  auto problem = tests::paper_case(1);
  problem.name = "it's a-1";
  run.cases.push_back({problem,
                       {named("a"), named("none"), named("b")},
                       {},
                       {},
                       {},
                       {},
                       {{"a", {{0, 1, 3}, {-2, 0, 1, 2}, {1, 2, 3, 4, 5, 6}}},
                        {"b", {{0, 1, 3}, {-2, 0, 1, 2}, {-1, 0, 0.5, 1e-30, 7, 8}}}}});
  run.cases.back().error_sources = {
      {"b", "y2", {{0, 1, 3}, {-2, 0, 1, 2}, {-1, 2, -3, 4, -5, 6}}},
      {"b", "v2", {{0, 1, 3}, {-2, 0, 1, 2}, {0.5, 0.25, 0, 1, 2, 4}}}};
  auto other = tests::make_problem({.restitution = 0.5});
  other.name = "case2";
  run.cases.push_back(
      {other, {named("a")}, {}, {}, {}, {}, {{"a", {{0, 5}, {-1, 0, 1}, {0.25, 0.75}}}}});
  return run;
}

void write(const fs::path& file, const results::Run& run) {
  PendingFiles files;
  add_joint_netcdf(files, file, run);
  files.commit();
}

void expect_same(const JointDensity& read, const JointDensity& written) {
  EXPECT_EQ(read.solution, written.solution);
  EXPECT_EQ(read.density.y_edges, written.density.y_edges);
  EXPECT_EQ(read.density.v_edges, written.density.v_edges);
  ASSERT_EQ(read.density.averages.size(), written.density.averages.size());
  for (std::size_t n = 0; n < read.density.averages.size(); ++n) {
    EXPECT_FLOAT_EQ(static_cast<float>(read.density.averages[n]),
                    static_cast<float>(written.density.averages[n]));
  }
}

TEST(JointNetCdf, HoldsTheDensitiesWithNamedAxesAndWhatTheyAreOf) {
  const tests::TemporaryDirectory directory;
  write(directory.path() / "joint.nc", small_run());
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
  const results::Run run = small_run();
  write(file, run);
  const auto [read, sources] = read_joint_netcdf(file);
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[0].case_name, "it's a-1");
  EXPECT_EQ(sources[0].source.solution, "b");
  EXPECT_EQ(sources[0].source.moment, "y2");
  EXPECT_EQ(sources[1].source.moment, "v2");
  EXPECT_EQ(sources[1].source.density.averages, run.cases[0].error_sources[1].density.averages);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[1].case_name, "it's a-1");
  EXPECT_EQ(read[2].case_name, "case2");
  expect_same(read[0].joint, run.cases[0].joints[0]);
  expect_same(read[1].joint, run.cases[0].joints[1]);
  expect_same(read[2].joint, run.cases[1].joints[0]);
}

TEST(JointNetCdf, ThatIsBrokenIsRefusedInOneLine) {
  const tests::TemporaryDirectory directory;
  const fs::path file = directory.path() / "joint.nc";
  write(file, small_run());
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

// Of few bytes, with dimensions whose product is more than there are numbers for, or memory.
TEST(JointNetCdf, ThatClaimsEndlessValuesIsRefused) {
  const tests::TemporaryDirectory directory;
  const fs::path path = directory.path() / "joint.nc";
  for (const auto& [rows, columns] : {std::pair(std::size_t{1} << 62, std::size_t{4}),
                                      std::pair(std::size_t{1} << 40, std::size_t{1})}) {
    int file = 0, dimensions[2], variable = 0;
    ASSERT_EQ(nc_create(path.c_str(), NC_CLOBBER | NC_NETCDF4, &file), NC_NOERR);
    ASSERT_EQ(nc_def_dim(file, "solution", rows, &dimensions[0]), NC_NOERR);
    ASSERT_EQ(nc_def_dim(file, "length", columns, &dimensions[1]), NC_NOERR);
    ASSERT_EQ(nc_def_var(file, "solution", NC_CHAR, 2, dimensions, &variable), NC_NOERR);
    nc_close(file);
    try {
      read_joint_netcdf(path);
      ADD_FAILURE() << "accepted " << rows << " times " << columns;
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), "more than 33554432 values")) << error.what();
    }
  }
}

// Of the classic format, whose lengths the library believes before it looks at the rest.
TEST(JointNetCdf, OfAnOlderFormatIsRefused) {
  const tests::TemporaryDirectory directory;
  const fs::path file = directory.path() / "joint.nc";
  write_file(file, std::string("CDF\1\0\0\0\0\0\0\0\n\0\0\0\1\x7f\xff\xff\xff", 20));
  try {
    read_joint_netcdf(file);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "no netCDF-4 file")) << error.what();
  }
}

}  // namespace
}  // namespace fpkcheck::results
