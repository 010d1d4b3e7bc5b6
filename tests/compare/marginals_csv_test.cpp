#include "compare/marginals_csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "made_up_solutions.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MarginalsCsv, ReadsBackExactlyWhatItWrote) {
  const auto curves = marginal_curves(std::vector<CaseReport>{tests::full_report("a \"b\", c")});
  std::stringstream csv;
  write_marginals_csv(csv, curves);
  EXPECT_TRUE(csv.str().starts_with("case,solution,variable,abscissa,density,lower,upper\n"));
  EXPECT_EQ(read_marginals_csv(csv, "m.csv"), curves);
}

TEST(MarginalsCsv, IsReadWithTheLineEndsOfOtherSystems) {
  const auto curves = marginal_curves(std::vector<CaseReport>{tests::full_report()});
  std::stringstream csv;
  write_marginals_csv(csv, curves);
  std::string crlf;
  for (const char c : csv.str()) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  std::istringstream in(crlf);
  EXPECT_EQ(read_marginals_csv(in, "m.csv"), curves);
}

TEST(MarginalsCsv, TellsNeighbouringCurvesApart) {
  const std::vector<MarginalCurve> curves{{"a", "s", "y", {0.5}, {1}, {}, {}},
                                          {"a", "s", "ydot", {0.5}, {2}, {}, {}},
                                          {"a", "t", "ydot", {0.5}, {3}, {}, {}},
                                          {"b", "t", "ydot", {0.5}, {4}, {}, {}}};
  std::stringstream csv;
  write_marginals_csv(csv, curves);
  EXPECT_EQ(read_marginals_csv(csv, "m.csv"), curves);
}

TEST(MarginalsCsv, LeavesTheIntervalEmptyWhereThereIsNone) {
  std::ostringstream csv;
  write_marginals_csv(csv,
                      std::vector<MarginalCurve>{{"c", "s", "y", {0.5}, {0.25}, {}, {}},
                                                 {"c", "t", "y", {0.5}, {0.25}, {0.125}, {1}}});
  EXPECT_EQ(csv.str(),
            "case,solution,variable,abscissa,density,lower,upper\n"
            "c,s,y,0.5,0.25,,\n"
            "c,t,y,0.5,0.25,0.125,1\n");
}

TEST(MarginalsCsv, NamesTheLineThatIsWrong) {
  const std::string header = "case,solution,variable,abscissa,density,lower,upper\n";
  const auto message = [](const std::string& text) -> std::string {
    std::istringstream csv(text);
    try {
      read_marginals_csv(csv, "m.csv");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_TRUE(contains(message("a,b\n"), "m.csv:1: not a file of marginals"));
  EXPECT_TRUE(contains(message(""), "m.csv:1: not a file of marginals"));
  EXPECT_TRUE(contains(message(header + "c,s,y,0,1,,\nc,s,y,0\n"), "m.csv:3: 4 fields"));
  EXPECT_TRUE(contains(message(header + "c,s,y,0,one,,\n"), "m.csv:2: 'one' is not a number"));
  EXPECT_TRUE(contains(message(header + "c,s,z,0,1,,\n"), "variable 'z'"));
  EXPECT_TRUE(contains(message(header + "c,s,y,0,1,0,2\nc,s,y,1,1,,\n"), "m.csv:3: intervals"));
}

}  // namespace
}  // namespace fpkcheck::compare
