#include "results/joint_netcdf.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "made_up_solutions.hpp"
#include "opened_netcdf.hpp"
#include "refusal.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;
using tests::contains;
using tests::contents;

transform::Solution named(const std::string& id) { return {.identity = {.id = id, .method = "m"}}; }

// Two cases with different cells and distinct numbers; the solution "b" is in the first case only.
results::Run small_run() {
  results::Run run{current_program("fpkcheck run"), {}};
  auto problem = tests::paper_case(1);
  problem.name = "it's a-1";
  run.cases.push_back({problem,
                       {named("a"), named("none"), named("b")},
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
      {other, {named("a")}, {}, {}, {}, {{"a", {{0, 5}, {-1, 0, 1}, {0.25, 0.75}}}}});
  return run;
}

void write(const fs::path& file, const results::Run& run) {
  base::write_file_atomically(file, joint_netcdf_bytes(run));
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

TEST(JointNetCdf, ContainsDensitiesWithNamedAxesAndAttributes) {
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
  EXPECT_EQ(read[0].case_name, "case2");
  EXPECT_EQ(read[1].case_name, "it's a-1");
  expect_same(read[0].joint, run.cases[1].joints[0]);
  expect_same(read[1].joint, run.cases[0].joints[0]);
  expect_same(read[2].joint, run.cases[0].joints[1]);
}

TEST(JointNetCdf, RefusesCorruptFiles) {
  const tests::TemporaryDirectory directory;
  const fs::path file = directory.path() / "joint.nc";
  write(file, small_run());
  const std::string whole = contents(file);
  for (const std::string& broken :
       {std::string(), std::string("not netCDF"), whole.substr(0, whole.size() / 2)}) {
    base::write_file_atomically(file, broken);
    try {
      read_joint_netcdf(file);
      ADD_FAILURE() << "accepted " << broken.size() << " bytes of " << whole.size();
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), file.string())) << error.what();
      EXPECT_FALSE(contains(error.what(), "\n")) << error.what();
    }
  }
}

/// A file whose declared sizes exceed its contents.
class DeclaredSizes : public testing::Test {
 protected:
  /// @param lengths of the dimensions of p_case1
  void declare(const std::vector<std::size_t>& lengths, const std::vector<std::size_t>& chunk,
               nc_type type = NC_FLOAT, int format = NC_NETCDF4) {
    int id = 0, labels = 0, characters = 0, variable = 0;
    ASSERT_EQ(nc_create(file_.c_str(), NC_CLOBBER | format, &id), NC_NOERR);
    std::vector<int> dimensions;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const std::string name = "d" + std::to_string(k);
      nc_def_dim(id, name.c_str(), lengths[k], &dimensions.emplace_back());
    }
    nc_def_dim(id, "characters", 1, &characters);
    const int of_labels[] = {dimensions[0], characters};
    ASSERT_EQ(nc_def_var(id, "solution", NC_CHAR, 2, of_labels, &labels), NC_NOERR);
    ASSERT_EQ(nc_def_var(id, "p_case1", type, 3, dimensions.data(), &variable), NC_NOERR);
    if (!chunk.empty()) {
      ASSERT_EQ(nc_def_var_chunking(id, variable, NC_CHUNKED, chunk.data()), NC_NOERR);
    }
    const int length_of[] = {dimensions[1], dimensions[2]};
    for (int k = 1; k <= 2; ++k) {
      int coordinate = 0, bounds = 0, two = 0;
      const std::string name = "d" + std::to_string(k), of_bounds = name + "_bounds";
      nc_def_dim(id, ("two" + name).c_str(), 2, &two);
      const int both[] = {length_of[k - 1], two};
      nc_def_var(id, name.c_str(), NC_DOUBLE, 1, both, &coordinate);
      nc_put_att_text(id, coordinate, "bounds", of_bounds.size(), of_bounds.data());
      nc_def_var(id, of_bounds.c_str(), NC_DOUBLE, 2, both, &bounds);
      const std::size_t of_one[] = {1, 2};  // unwritten chunks take no space
      nc_def_var_chunking(id, bounds, NC_CHUNKED, of_one);
    }
    nc_close(id);
  }
  std::string refusal() const {
    return tests::refusal([&] { read_joint_netcdf(file_); });
  }

  tests::TemporaryDirectory directory_;
  fs::path file_ = directory_.path() / "joint.nc";
};

TEST_F(DeclaredSizes, BeyondTheContentsAreRefusedBeforeAllocation) {
  const std::size_t many = 3'000'000'000;
  declare({many, 2, 2}, {1, 2, 2});
  EXPECT_TRUE(contains(refusal(), "not a list of texts")) << refusal();
  declare({1, many, many}, {1, 1, 1});
  EXPECT_TRUE(contains(refusal(), "more than")) << refusal();
  // A product beyond 2^64.
  declare({5000, many, many}, {1, 1, 1});
  EXPECT_TRUE(contains(refusal(), "more than")) << refusal();
  declare({1, 4'000'000, 1}, {1, 1, 1});
  EXPECT_TRUE(contains(refusal(), "more values than the file can contain")) << refusal();
}

TEST_F(DeclaredSizes, OfOtherFormatsAndTypesAreRefused) {
  declare({1, 1, 1}, {}, NC_FLOAT, NC_64BIT_DATA);
  EXPECT_TRUE(contains(refusal(), "not netCDF-4")) << refusal();
  declare({1, 1, 1}, {}, NC_STRING);
  EXPECT_TRUE(contains(refusal(), "not a complete file")) << refusal();
}

// libnetcdf would interpret one path as a network address and another as two directories.
TEST(JointNetCdf, IsReadFromDirectoriesWithAnyName) {
  const tests::TemporaryDirectory directory;
  const fs::path whole = directory.path() / "joint.nc";
  write(whole, small_run());
  for (const char* name : {"http:/h", "x\\y", "  z", "file#mode=bytes"}) {
    const fs::path other = directory.path() / name;
    fs::create_directories(other);
    fs::copy_file(whole, other / "joint.nc");
    EXPECT_EQ(read_joint_netcdf(other / "joint.nc").joints.size(), 3u) << name;
  }
}

using transform::StateVariable;

const compare::ComparisonBins kAxes = compare::comparison_bins(tests::paper_case(1));

// The eight synthetic solutions; the simulation's histogram is too rough for interpolation.
std::vector<transform::Solution> solutions_with_histogram() {
  auto solutions = tests::made_up_solutions(kAxes);
  transform::GridDensity histogram{kAxes.y_edges, kAxes.v_edges, {}};
  for (std::size_t k = 0; k < 140 * 140; ++k) {
    histogram.averages.push_back(static_cast<double>(k * 7919 % 5));
  }
  solutions.back().density = histogram;
  return solutions;
}

TEST(JointDensities, HaveTheOrderOfTheSolutions) {
  const auto found = [](const std::vector<transform::Solution>& solutions) {
    std::string ids;
    for (const auto& joint : joint_densities_on_comparison_cells(kAxes, solutions))
      ids += joint.solution + ' ';
    return ids;
  };
  const std::string all = "epc-gaussian-n2 epc-gaussian-n4 epc-gaussian-n6 fd-white fd-km4 fd-kf ";
  EXPECT_EQ(found(tests::made_up_solutions(kAxes)), all);
  EXPECT_EQ(found(solutions_with_histogram()), all + "mcs ");
}

TEST(JointDensities, HaveMassOneAndTheMarginalsOfTheRun) {
  const auto one = tests::made_up_case();
  constexpr double kSinglePrecision = 6e-8;
  for (const auto& [solution, density] : one.joints) {
    ASSERT_EQ(density.y_cell_count(), 70u);
    ASSERT_EQ(density.v_cell_count(), 140u);
    EXPECT_NEAR(mass(density), 1, 1e-6) << solution;
    for (const auto variable : transform::kVariables) {
      const auto& bins = variable == StateVariable::y ? density.y_edges : density.v_edges;
      const auto own = transform::marginal(density, variable, bins);
      const auto& p = one.marginal_curve(solution, variable)->density;
      for (std::size_t b = 0; b < own.size(); ++b) {
        const double expected = variable == StateVariable::y ? (p[2 * b] + p[2 * b + 1]) / 2 : p[b];
        EXPECT_NEAR(own.density[b], expected, kSinglePrecision) << solution << " bin " << b;
      }
    }
  }
}

TEST(JointDensities, OfASimulationSumItsCells) {
  const auto solutions = solutions_with_histogram();
  const auto joint = joint_densities_on_comparison_cells(kAxes, solutions).back();
  ASSERT_EQ(joint.solution, "mcs");
  const auto& histogram = std::get<transform::GridDensity>(*solutions.back().density);
  for (const auto& [i, j] : {std::pair{0, 0}, {3, 69}, {3, 70}, {69, 139}}) {
    EXPECT_NEAR(joint.density.cell_average(i, j),
                (histogram.cell_average(2 * i, j) + histogram.cell_average(2 * i + 1, j)) / 2, 1e-6)
        << i << " " << j;
  }
}

}  // namespace
}  // namespace fpkcheck::results
