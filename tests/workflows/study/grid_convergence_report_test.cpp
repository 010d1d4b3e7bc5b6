#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(GridFiles, JsonHasTheLimitsTheGridsAndTheOtherMethods) {
  const auto found =
      nlohmann::json::parse(study_json_text(tests::made_up_grid_study(), "fpkcheck study grid"));
  EXPECT_EQ(found.at("study"), "grid");
  EXPECT_EQ(found.at("equation"), "kf");
  EXPECT_EQ(found.at("impact"), "map");
  EXPECT_EQ(found.at("truth").at("order"), 5);
  EXPECT_EQ(found.at("truth").at("known_to").at("y"), 1.2e-4);
  EXPECT_EQ(found.at("limits").at(1).at("y2"), 0.39451776);
  EXPECT_EQ(found.at("limits").at(1).at("v2_error"), 2e-6);
  ASSERT_EQ(found.at("rows").size(), 6u);
  const auto& finest = found.at("rows").at(2);
  EXPECT_EQ(finest.at("order"), 3);
  EXPECT_EQ(finest.at("nv"), 60);
  EXPECT_EQ(finest.at("observed_order").at("l1"), 2.75);
  EXPECT_TRUE(finest.at("observed_order").at("v2").is_null());  // not finite
  EXPECT_TRUE(found.at("rows").at(1).at("observed_order").at("l1").is_null());
  EXPECT_EQ(finest.at("v2"), 0.5);
  const auto& others = found.at("others");
  EXPECT_EQ(others.at(0).at("formulation"), "gaussian");
  EXPECT_EQ(others.at(1).at("reason"), "it is made up");
  EXPECT_TRUE(others.at(1).at("l1_y").is_null());
  EXPECT_TRUE(others.at(1).at("sampling_l1").is_null());
  EXPECT_TRUE(others.at(3).at("formulation").is_null());
  EXPECT_EQ(others.at(3).at("sampling_l1").at("ydot"), 0.0015);
}

TEST(GridFiles, JsonHasTheReasonWithoutALimit) {
  auto study = tests::made_up_grid_study();
  study.limits.back() = {.order = 5, .failure = "nothing converges"};
  const auto found = nlohmann::json::parse(study_json_text(study, ""));
  EXPECT_TRUE(found.at("truth").at("order").is_null());
  EXPECT_EQ(found.at("truth").at("reason"), "nothing converges");
  EXPECT_TRUE(found.at("limits").at(1).at("y2").is_null());
  EXPECT_TRUE(found.at("limits").at(1).at("y2_error").is_null());
}

TEST(GridFiles, CsvHasGridsAndOthersUnderOneHeader) {
  const std::string text = study_csv_text(tests::made_up_grid_study());
  EXPECT_TRUE(
      text.starts_with("id,order,level,nx,nv,status,l1_y,l1_ydot,observed_order,seconds\n"
                       "fd-kf,3,1,10,20,inadmissible,"))
      << text;
  EXPECT_NE(text.find("\nfd-kf,3,3,30,60,ok,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nepc-gaussian-n4,4,,,,inadmissible,,,,0.002\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nmcs,,,,,ok,0.001,0.002,,2\n"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 6 + 4);
}

TEST(GridTable, ShowsGridsLimitsOtherMethodsAndTheFastest) {
  const std::string text = tests::in_one_line(study_table_text(tests::made_up_grid_study(), 100));
  for (const char* expected :
       {"finite volumes for kf, impact map", "3 30 x 60 ok 3.7e-03 7.4e-03 2.8 7.0 - 900",
        "3 10 x 20 inadmissible", "5 0.39451776 1e-06 0.4415 2e-06 0 0 0.0e+00 1.4e-04",
        "epc-gaussian-n2 ok 4.4e-03 3.0e-02 6.7", "epc-gaussian-n4 inadmissible - - 2.0",
        "order 3 on 10 x 20 cells inadmissible: it is made up",
        "epc-gaussian-n4 inadmissible: it is made up",
        "The limit is that of order 5; the limit of the next lower order differs by L1 1.2e-04 in "
        "p(y) and 1.4e-04 in p(y')",
        "Fastest to L1 1e-02 in both marginals: epc-moment-n4 in 30 ms; finite volumes of "
        "order 3 on 30 x 60 cells in 900 ms; mcs in 2000 ms.",
        "Fastest to L1 1e-03 in both marginals: epc-moment-n4 in 30 ms.",
        "observed order: from the differences of the last three levels."}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
  EXPECT_EQ(text.find("Fastest to L1 1e-04"), std::string::npos) << text;
}

TEST(GridTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    EXPECT_LE(tests::longest_line(study_table_text(tests::made_up_grid_study(), width)), width);
  }
}

TEST(GridTable, HasTheReasonWithoutALimit) {
  auto study = tests::made_up_grid_study();
  study.limits.back() = {.order = 5, .failure = "nothing converges"};
  study.others.clear();
  const std::string text = study_table_text(study, 100);
  EXPECT_NE(text.find("There is no limit at the highest order: nothing converges."),
            std::string::npos);
  EXPECT_EQ(text.find("other methods"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::study
