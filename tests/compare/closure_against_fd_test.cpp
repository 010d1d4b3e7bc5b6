#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "compare/study/order.hpp"
#include "compare/summary_view.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

Json study(const problem::Problem& problem, std::vector<std::string> formulations,
           std::vector<int> orders) {
  return study_orders("test", problem, {std::move(formulations), std::move(orders)},
                      [](const auto&) {});
}

const Json& row_of(const Json& report, const std::string& formulation, int order) {
  for (const auto& row : report.at("rows")) {
    if (row.at("formulation") == formulation && row.at("order") == order) return row;
  }
  throw std::logic_error("no such row");
}

// The closure on the half-plane and finite differences share nothing but the problem. Bars a few
// per cent above what was measured; finite differences are good to 6e-5.
TEST(MomentClosure, ComesAsNearToFiniteDifferencesAsItsOrderAllows) {
  const std::map<int, std::pair<double, double>> bars{
      {6, {0.003, 0.004}}, {8, {0.0015, 0.0025}}, {12, {0.0005, 0.0018}}};
  for (const int number : {1, 2, 3, 4}) {
    const Json report = study(tests::paper_case(number), {"moment"}, {6, 8, 12});
    for (const auto& [order, bar] : bars) {
      SCOPED_TRACE("case " + std::to_string(number) + ", n = " + std::to_string(order));
      const Json& row = row_of(report, "moment", order);
      EXPECT_EQ(row.at("status"), "ok");
      EXPECT_LT(row.at("l1_y").get<double>(), bar.first);
      EXPECT_LT(row.at("l1_ydot").get<double>(), bar.second);
      // Were the two the same computation, they would agree to rounding.
      EXPECT_GT(row.at("l1_ydot").get<double>(), 1e-4);
      if (order == 8) {
        EXPECT_LT(row.at("tail_y").get<double>(), 0.1);
        EXPECT_LT(row.at("tail_ydot").get<double>(), 0.1);
      }
    }
  }
}

// Other laws, a mean of the impulses, stronger losses: the same process on both sides.
TEST(MomentClosure, FollowsEveryImpulseLawAndMean) {
  for (const char* law : {"laplace", "two_point", "uniform"}) {
    for (const double mean : {-0.1, 0.15}) {
      const auto p =
          tests::make_problem({.restitution = 0.95, .rate = 3, .mean = mean, .law = law});
      const Json report = study(p, {"moment"}, {2, 8});
      SCOPED_TRACE(std::string(law) + ", mean " + std::to_string(mean));
      const Json &coarse = row_of(report, "moment", 2), &fine = row_of(report, "moment", 8);
      EXPECT_EQ(fine.at("status"), "ok");
      EXPECT_LT(fine.at("l1_y").get<double>(), 0.005);
      EXPECT_LT(fine.at("l1_ydot").get<double>(), 0.008);
      EXPECT_LT(fine.at("l1_ydot").get<double>(), coarse.at("l1_ydot").get<double>() / 3);
    }
  }
}

// The same at equal numbers of unknowns, with the exponent in amplitude and phase: strong losses
// and rare impulses too, where polynomials of y and y' miss the step at the origin. Bars 35
// to 80 per cent above what was measured.
TEST(PolarClosure, CarriesTheStepAtTheOrigin) {
  struct Bars {
    tests::Parameters parameters;
    double y, ydot;    // at n = 6
    double advantage;  // least ratio of the L1 of p(y') of moment and polar, both at n = 6
  };
  for (const auto& [parameters, y, ydot, advantage] :
       {Bars{{}, 2e-4, 2.2e-4, 12},                            //
        Bars{{.cubic = 1, .intensity = 1}, 2e-4, 2.5e-4, 10},  //
        Bars{{.restitution = 0.8}, 4e-4, 9e-4, 30},            //
        Bars{{.restitution = 0.5}, 2.2e-3, 4e-3, 30},          //
        Bars{{.rate = 0.3}, 1.3e-3, 1.3e-3, 20}}) {
    SCOPED_TRACE("r = " + std::to_string(parameters.restitution) +
                 ", lambda = " + std::to_string(parameters.rate));
    const Json report = study(tests::make_problem(parameters), {"moment", "polar"}, {6});
    const Json &moment = row_of(report, "moment", 6), &polar = row_of(report, "polar", 6);
    EXPECT_EQ(polar.at("status"), "ok");
    EXPECT_LT(polar.at("l1_y").get<double>(), y);
    EXPECT_LT(polar.at("l1_ydot").get<double>(), ydot);
    EXPECT_GT(moment.at("l1_ydot").get<double>() / polar.at("l1_ydot").get<double>(), advantage);
  }
}

TEST(OrderStudy, TabulatesSavesAndDrawsWhatItFound) {
  const Json report = study(tests::paper_case(4), {"gaussian", "moment-cut"}, {2, 4});
  ASSERT_EQ(report.at("rows").size(), 4u);
  EXPECT_EQ(report.at("reference").at("id"), "fd-kf");
  EXPECT_EQ(row_of(report, "gaussian", 4).at("status"), "inadmissible");
  EXPECT_TRUE(number(row_of(report, "gaussian", 4), "l1_y").has_value());

  const std::string csv = order_csv(report);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_NE(csv.find("\nmoment-cut,4,inadmissible,"), std::string::npos) << csv;

  for (const std::size_t width : {80u, 100u}) {
    const std::string table = order_table(report, width);
    EXPECT_NE(table.find("gaussian is ok at n = 2: L1"), std::string::npos) << table;
    EXPECT_NE(table.find("gaussian n = 4 inadmissible: "), std::string::npos) << table;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), width) << line;
  }

  const std::string figure = order_figure(report, "study-order");
  EXPECT_NE(figure.find("$ok_0 << EOD\n2 "), std::string::npos) << figure;
  EXPECT_NE(figure.find("$not_1 << EOD\n2 "), std::string::npos);
}

// A branch as the gaussian formulation reports it.
TEST(OrderStudy, SaysWhereABranchFolds) {
  Json report = study(tests::paper_case(1), {"gaussian"}, {2});
  const auto point = [](double fraction, bool fold) {
    return Json{{"fraction", fraction}, {"norm", 2 * fraction}, {"fold", fold}};
  };
  report["rows"][0]["branch"] = {
      {"end", "white_noise"},
      {"furthest", 0.653},
      {"points", {point(0, false), point(0.653, true), point(0.1, false)}}};
  const std::string table = order_table(report);
  EXPECT_NE(table.find("folds at 65.3 %"), std::string::npos) << table;
  const std::string figure = order_figure(report, "s");
  EXPECT_NE(figure.find("$branch_0 << EOD\n0 0 0\n0.653 1.306 1\n0.1 0.2 0\nEOD"),
            std::string::npos)
      << figure;
}

}  // namespace
}  // namespace fpkcheck::compare
