#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compare/study/regularisation.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::compare {
namespace {

fd_fpk::RegularisationStudy made_up() {
  using Row = fd_fpk::RegularisationRow;
  const fd_fpk::Growth none{-1e-6, 0.01};
  const auto settled = [&](const char* scheme, double step, double length) {
    return Row{.scheme = scheme,
               .step = step,
               .length = length,
               .nx = 16,
               .nv = 60,
               .symbol = none,
               .rightmost = -1e-15,
               .next = std::complex(-0.119, 2.1),
               .l1_y = 0.0003,
               .l1_ydot = 0.0004,
               .min_density = -1e-7};
  };
  const auto growing = [&](const char* scheme, double step, double length, double rate) {
    return Row{.scheme = scheme,
               .step = step,
               .length = length,
               .nx = 16,
               .nv = 60,
               .symbol = fd_fpk::Growth{1.1 * rate, 3 / step},
               .rightmost = rate,
               .l1_y = 4.1,
               .l1_ydot = 2.3,
               .min_density = -0.47};
  };
  auto unsolved = settled("pade", 0.2, 0);
  unsolved.symbol = std::nullopt;
  unsolved.rightmost = unsolved.next = std::nullopt;
  unsolved.l1_y = unsolved.l1_ydot = unsolved.min_density = std::nullopt;
  unsolved.remark = "there is none";
  return {.default_length = 0.4,
          .shortest_length = 0.3,
          .rows = {settled("literal", 0.4, 0.4), growing("literal", 0.2, 0.2, 20),
                   growing("literal", 0.1, 0.1, 320), growing("0.9 l*", 0.1, 0.27, 1.5),
                   settled("1.1 l*", 0.1, 0.33), settled("regularised", 0.4, 0.4),
                   settled("regularised", 0.1, 0.4), unsolved}};
}

nlohmann::ordered_json report() {
  return regularisation_report("fpkcheck study", tests::make_problem(), made_up());
}

std::string in_one_line(std::string text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += word + ' ';
  return line;
}

TEST(RegularisationTable, SaysInNumbersWhichSchemeGrowsAndWhichSettles) {
  const std::string text = in_one_line(regularisation_table(report()));
  for (const char* expected :
       {"literal 0.1 0.1 16x60 352 30 320 - x10 in 0.0072 4.10000 2.30000 -5e-01",
        "literal 0.4 0.4 16x60 0 - -1e-15 -0.119+-2.1i settles 0.00030 0.00040 -1e-07",
        "pade 0.2 - 16x60 - - - - - - - -", "pade at h = 0.2: there is none",
        "grows at h = 0.2 and 0.1, in the end as h^-4.00", "up to L1 2.3 from kf",
        "falls to -0.47 of its peak", "default length l = 0.4 grows on no step",
        "L1 0.0003 in p(y) and 0.0004 in p(y')", "threshold is l* = 0.3",
        "10 % below it grow h = 0.1", "10 % above it none grows"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
}

TEST(RegularisationTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    std::istringstream lines(regularisation_table(report(), width));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), width) << line;
  }
}

TEST(RegularisationReport, KeepsWhatIsAbsentAsNullAndWhatGrowsAsARate) {
  const auto json = report();
  EXPECT_EQ(json.at("system").at("restitution"), 0.98);
  EXPECT_EQ(json.at("rows").at(2).at("growth_rate"), 320.0);
  EXPECT_TRUE(json.at("rows").at(0).at("growth_rate").is_null());
  EXPECT_EQ(json.at("rows").at(0).at("next").at("im"), 2.1);
  EXPECT_TRUE(json.at("rows").at(7).at("rightmost").is_null());
  const std::string csv = regularisation_csv(json);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 9);
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::ranges::count(line, ','), 14) << line;
  }
}

}  // namespace
}  // namespace fpkcheck::compare
