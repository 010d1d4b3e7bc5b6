#include "results/marginals_csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "base/input_error.hpp"
#include "made_up_solutions.hpp"
#include "refusal.hpp"
#include "saved_run.hpp"

namespace fpkcheck::results {
namespace {

using transform::StateVariable;

/// The curves of a synthetic run with one case, and of cases that have only such curves.
std::vector<CaseResult> cases_with(
    std::vector<std::pair<std::string, std::vector<DensityCurve>>> curves) {
  std::vector<CaseResult> cases;
  for (auto& [name, own] : curves) {
    auto problem = tests::paper_case(1);
    problem.name = name;
    cases.push_back({problem, {}, {}, {}, std::move(own), {}});
  }
  return cases;
}

std::string written(const std::vector<CaseResult>& cases) {
  std::ostringstream csv;
  write_marginals_csv(csv, cases);
  return csv.str();
}

void expect_read_back(const std::string& csv, const std::vector<CaseResult>& cases) {
  std::istringstream in(csv);
  const auto read = read_marginals_csv(in, "m.csv");
  std::size_t k = 0;
  for (const auto& one : cases) {
    for (const auto& curve : one.curves) {
      ASSERT_LT(k, read.size());
      EXPECT_EQ(read[k].case_name, one.name());
      EXPECT_EQ(read[k].curve, curve);
      ++k;
    }
  }
  EXPECT_EQ(k, read.size());
}

TEST(MarginalsCsv, ReadsBackExactlyWhatItWrote) {
  const std::vector<CaseResult> cases{tests::made_up_case("a \"b\", c")};
  const std::string csv = written(cases);
  EXPECT_TRUE(csv.starts_with("case,solution,variable,abscissa,density,lower,upper\n"));
  expect_read_back(csv, cases);
}

TEST(MarginalsCsv, IsReadWithTheLineEndsOfOtherSystems) {
  const std::vector<CaseResult> cases{tests::made_up_case()};
  std::string crlf;
  for (const char c : written(cases)) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  expect_read_back(crlf, cases);
}

TEST(MarginalsCsv, SeparatesConsecutiveCurves) {
  const auto cases = cases_with({{"a",
                                  {{"s", StateVariable::y, {0.5}, {1}, {}, {}},
                                   {"s", StateVariable::ydot, {0.5}, {2}, {}, {}},
                                   {"t", StateVariable::ydot, {0.5}, {3}, {}, {}}}},
                                 {"b", {{"t", StateVariable::ydot, {0.5}, {4}, {}, {}}}}});
  expect_read_back(written(cases), cases);
}

TEST(MarginalsCsv, LeavesMissingIntervalsEmpty) {
  EXPECT_EQ(written(cases_with({{"c",
                                 {{"s", StateVariable::y, {0.5}, {0.25}, {}, {}},
                                  {"t", StateVariable::y, {0.5}, {0.25}, {0.125}, {1}}}}})),
            "case,solution,variable,abscissa,density,lower,upper\n"
            "c,s,y,0.5,0.25,,\n"
            "c,t,y,0.5,0.25,0.125,1\n");
}

// A simulation whose trajectories exceeded the range of numbers has a density that is not finite.
TEST(MarginalsCsv, AllowsNonFiniteNumbersOnlyOfFailedSolutions) {
  const std::string header = "case,solution,variable,abscissa,density,lower,upper\n";
  const auto read = [&](const std::string& row) -> std::string {
    std::istringstream csv(header + "c,fd-kf,y,0.5,1,,\n" + row);
    try {
      const auto curves = read_marginals_csv(
          csv, "m.csv",
          [](const std::string& one, const std::string& id) { return one == "c" && id == "mcs"; });
      return std::to_string(curves.size());
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(read("c,mcs,y,0.5,nan,-inf,inf\n"), "2");
  EXPECT_EQ(read("c,mcs,y,nan,1,0,2\n"), "m.csv:3: nan (numbers must be finite)");
  EXPECT_EQ(read("c,fd-kf,y,1.5,-inf,,\n"), "m.csv:3: -inf (numbers must be finite)");
  EXPECT_EQ(read("c,fd-kf,ydot,0.5,1,nan,2\n"), "m.csv:3: nan (numbers must be finite)");
  EXPECT_EQ(read("c,fd-kf,ydot,0.5,1,0,inf\n"), "m.csv:3: inf (numbers must be finite)");
}

TEST(MarginalsCsv, ReportsTheInvalidLine) {
  const std::string header = "case,solution,variable,abscissa,density,lower,upper\n";
  const auto message = [](const std::string& text) -> std::string {
    std::istringstream csv(text);
    return tests::refusal([&] { read_marginals_csv(csv, "m.csv"); });
  };
  EXPECT_TRUE(tests::contains(message("a,b\n"), "m.csv:1: not a file of marginals"));
  EXPECT_TRUE(tests::contains(message(""), "m.csv:1: not a file of marginals"));
  EXPECT_TRUE(tests::contains(message(header + "c,s,y,0,1,,\nc,s,y,0\n"), "m.csv:3: 4 fields"));
  EXPECT_TRUE(tests::contains(message(header + "c,s,y,0,1,0,\n"), "m.csv:2: an interval has one"));
  EXPECT_TRUE(
      tests::contains(message(header + "c,s,y,0,one,,\n"), "m.csv:2: 'one' is not a number"));
  EXPECT_TRUE(tests::contains(message(header + "c,s,z,0,1,,\n"), "variable 'z'"));
  EXPECT_TRUE(tests::contains(message(header + "c,s,y,0,1,0,2\nc,s,y,1,1,,\n"),
                              "m.csv:3: a curve has intervals"));
}

}  // namespace
}  // namespace fpkcheck::results
