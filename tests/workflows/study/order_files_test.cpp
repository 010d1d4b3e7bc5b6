#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(OrderFiles, JsonHasTheReferenceAndTheMetricsOfEachClosure) {
  const auto found =
      nlohmann::json::parse(json(tests::made_up_order_study(), "fpkcheck study order"));
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
  const std::string text = csv(tests::made_up_order_study());
  EXPECT_EQ(text,
            "formulation,order,status,iterations,residual,condition,l1_y,l1_ydot,tail_y,tail_ydot,"
            "seconds\n"
            "gaussian,2,ok,14,1e-15,,0.004,0.008,0.04,,0.002\n"
            "gaussian,4,inadmissible,28,1e-15,,0.026,0.052,0.08,,0.004\n"
            "gaussian,8,not_converged,,,,,,,,0.002\n"
            "moment,4,ok,28,1e-15,,0.008,0.016,0.08,,0.004\n"
            "moment,6,ok,42,1e-15,,0.002,0.004,0.12,,0.006\n");
}

}  // namespace
}  // namespace fpkcheck::study
