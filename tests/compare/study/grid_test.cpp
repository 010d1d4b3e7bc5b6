#include "compare/study/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "paper_cases.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

// White noise without losses: the density is smooth, so that every scheme shows its order.
problem::Problem without_losses() {
  return {"smooth",
          problem::System{{.damping = 0.1, .stiffness = 1.0, .cubic = 0.1, .restitution = 1.0}},
          problem::ImpulseTrain{{1.0, "gaussian", 0.1, 0.0}}};
}

// Solved once a process, and each test is one: two tests share it.
const Json& white_noise_study() {
  static const Json report = study_grid("fpkcheck study grid", without_losses(),
                                        {.equation = fd_fpk::Equation::white,
                                         .orders = {5, 3},
                                         .levels = 4,
                                         .coarsest = 0.5,
                                         .simulation = {.time = 3e3}},
                                        {});
  return report;
}

Json row(const Json& report, int order, int level) {
  for (const auto& row : report.at("rows")) {
    if (row.at("order") == order && row.at("level") == level) return row;
  }
  return nullptr;
}

TEST(GridStudy, ConvergesAtTheOrderOfEachScheme) {
  const Json& report = white_noise_study();
  ASSERT_EQ(report.at("rows").size(), 8u);
  EXPECT_TRUE(row(report, 3, 2).at("observed_order").at("l1").is_null());  // three levels make one
  EXPECT_NEAR(row(report, 3, 4).at("observed_order").at("l1").get<double>(), 3, 0.5);
  EXPECT_NEAR(row(report, 5, 4).at("observed_order").at("l1").get<double>(), 5, 0.7);

  // Distances are from the limit of the highest order.
  EXPECT_EQ(report.at("truth").at("order"), 5);
  EXPECT_EQ(report.at("limits").at(1).at("l1_y"), 0.0);
  // The limits of both orders agree better than the finest grid of the lower one is exact.
  EXPECT_LT(report.at("truth").at("known_to").at("y").get<double>(),
            row(report, 3, 4).at("l1_y").get<double>() / 3);
  for (const int order : {3, 5}) {
    for (int level = 2; level <= 4; ++level) {
      EXPECT_LT(row(report, order, level).at("l1_ydot").get<double>(),
                0.6 * row(report, order, level - 1).at("l1_ydot").get<double>());
    }
  }

  // E[y'^2] = intensity / (2 c) is exact for white noise at r = 1.
  const Json& limits = report.at("limits");
  const double finest = row(report, 3, 4).at("v2").get<double>();
  EXPECT_LT(std::abs(limits.at(0).at("v2").get<double>() - 0.5), std::abs(finest - 0.5) / 3);
  EXPECT_NEAR(limits.at(1).at("v2").get<double>(), 0.5, 2e-6);
}

TEST(GridStudy, ShowsTheOtherMethodsOfTheSameEquationWithTheirCost) {
  const Json& others = white_noise_study().at("others");
  ASSERT_FALSE(others.empty());
  EXPECT_EQ(others.front().at("id"), "epc-moment-white-n2");
  EXPECT_EQ(others.back().at("id"), "mcs-white");
  for (const auto& other : others) {
    EXPECT_GT(other.at("seconds").get<double>(), 0) << other.at("id");
    ASSERT_TRUE(other.at("l1_y").is_number()) << other.at("id");
  }
  // Exact from n = 4 on: what is left is the error of the truth.
  EXPECT_LT(others.at(1).at("l1_y").get<double>(), 1e-4);

  const auto table = grid_table(white_noise_study());
  EXPECT_NE(table.find("Richardson limit"), std::string::npos);
  EXPECT_NE(table.find("Quickest to L1 1e-03 in both marginals: "), std::string::npos);
  for (std::size_t from = 0; from < table.size();) {
    const auto end = table.find('\n', from);
    EXPECT_LE(end - from, 100u) << table.substr(from, end - from);
    from = end + 1;
  }
  const auto csv = grid_csv(white_noise_study());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 8 + 7);
  const auto figure = grid_figure(white_noise_study(), "study-grid");
  EXPECT_NE(figure.find("closure, moment-white"), std::string::npos);
  EXPECT_NE(figure.find("simulation"), std::string::npos);
}

// All levels come to the smallest grid there is: nothing converges, and nothing is claimed.
TEST(GridStudy, HasNoTruthWithoutALimit) {
  const Json report = study_grid("fpkcheck study grid", tests::paper_case(1),
                                 {.orders = {5}, .levels = 3, .coarsest = 0.02}, {});
  EXPECT_TRUE(report.at("truth").at("order").is_null());
  EXPECT_TRUE(report.at("others").empty());
  EXPECT_NE(grid_table(report).find("There is no limit at the highest order: "), std::string::npos);
  EXPECT_EQ(grid_figure(report, "study-grid"), "");
}

TEST(GridStudy, RefusesWhatCannotBeStudied) {
  const auto refusal = [](const GridStudyOptions& options) {
    try {
      validate(options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refusal({.levels = 2}).find("--levels 2"), std::string::npos);
  EXPECT_NE(refusal({.orders = {}}).find("--orders"), std::string::npos);
  EXPECT_NE(refusal({.orders = {9}}), "accepted");
  EXPECT_NE(refusal({.coarsest = -1}), "accepted");
  EXPECT_EQ(refusal({}), "accepted");
}

}  // namespace
}  // namespace fpkcheck::compare
