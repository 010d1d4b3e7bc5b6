#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(OrderFiles, JsonHasTheReferenceAndTheMetricsOfEachClosure) {
  const auto found =
      nlohmann::json::parse(study_json_text(tests::made_up_order_study(), "fpkcheck study order"));
  EXPECT_EQ(found.at("study"), "order");
  EXPECT_EQ(found.at("reference").at("id"), "fd-kf");
  ASSERT_EQ(found.at("rows").size(), 5u);
  const auto& row = found.at("rows").at(4);
  EXPECT_EQ(row.at("id"), "epc-moment-n6");
  EXPECT_EQ(row.at("formulation"), "moment");
  EXPECT_EQ(row.at("order"), 6);
  EXPECT_EQ(row.at("iterations"), 42);
  EXPECT_EQ(row.at("support").at("edge_density"), 1e-14);
  EXPECT_EQ(row.at("l1_ydot"), 0.004);
  EXPECT_TRUE(row.at("tail_ydot").is_null());
  const auto& lost = found.at("rows").at(2);
  EXPECT_EQ(lost.at("status"), "not_converged");
  EXPECT_TRUE(lost.at("l1_y").is_null());
  EXPECT_TRUE(lost.at("mass").is_null());
  EXPECT_EQ(lost.at("branch").at("points").at(1).at("fold"), true);
}

TEST(OrderFiles, CsvHasEmptyCellsForMissingValues) {
  const std::string text = study_csv_text(tests::made_up_order_study());
  EXPECT_EQ(text,
            "formulation,order,status,iterations,residual,condition,l1_y,l1_ydot,tail_y,tail_ydot,"
            "seconds\n"
            "gaussian,2,ok,14,1e-15,,0.004,0.008,0.04,,0.002\n"
            "gaussian,4,inadmissible,28,1e-15,,0.026,0.052,0.08,,0.004\n"
            "gaussian,8,not_converged,,,,,,,,0.002\n"
            "moment,4,ok,28,1e-15,,0.008,0.016,0.08,,0.004\n"
            "moment,6,ok,42,1e-15,,0.002,0.004,0.12,,0.006\n");
}

TEST(OrderTable, ShowsMetricsAndConvergence) {
  const std::string text = tests::in_one_line(study_table_text(tests::made_up_order_study(), 120));
  for (const char* expected :
       {"L1 to fd-kf", "gaussian 2 ok 14 - 1e-15 falls 1e-14 - 0.00400 0.00800 0.04 - 2",
        "gaussian 8 not_converged - - - - - - - - - - 2",
        "moment 6 ok 42 - 1e-15 rises 1e-14 - 0.00200 0.00400 0.12 - 6",
        "gaussian n = 4 inadmissible: Q_n rises",
        "gaussian n = 8: the branch of solutions from the exact density of white noise without "
        "impact losses folds at 65.5 %, covers 65.5 % of the way, and returns to white "
        "noise at another root.",
        "gaussian is ok at n = 2: L1 0.004 in p(y), 0.008 in p(y').",
        "moment is ok at n = 4 and 6; from n = 4 to 6 the L1 distance changes from 0.008 to 0.002 "
        "in p(y) and from 0.016 to 0.004 in p(y'). On average each n + 2 divides it by 4.0 and "
        "4.0."}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
}

TEST(OrderTable, ReportsMissingDensitiesAndAReferenceThatIsNotOk) {
  auto study = tests::made_up_order_study();
  study.rows.erase(study.rows.begin(), study.rows.begin() + 2);
  study.reference.status = transform::Status::failed;
  study.reference.reason = "the box is too small";
  const std::string text = tests::in_one_line(study_table_text(study, 100));
  EXPECT_NE(text.find("gaussian: no order gives a density."), std::string::npos) << text;
  EXPECT_NE(text.find("The reference fd-kf is failed: the box is too small"), std::string::npos);
}

TEST(OrderTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    EXPECT_LE(tests::longest_line(study_table_text(tests::made_up_order_study(), width)), width);
  }
}

}  // namespace
}  // namespace fpkcheck::study
