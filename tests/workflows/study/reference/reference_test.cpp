#include <gtest/gtest.h>

#include <cmath>

#include "exact/closed_forms.hpp"
#include "exact/linear_density.hpp"
#include "paper_cases.hpp"
#include "workflows/study/reference/reference.hpp"

namespace fpkcheck::study {
namespace {

TEST(Reference, AgreedDigitsEndAtTheDifference) {
  EXPECT_EQ((ValueInTwoSchemeOrders{1.2345678, 1.2345679}.agreed_significant_digits(7)), 7);
  EXPECT_EQ((ValueInTwoSchemeOrders{1.2345, 1.2346}.agreed_significant_digits(7)), 4);
  EXPECT_EQ((ValueInTwoSchemeOrders{1.2345, 1.2346}.agreed_significant_digits(3)), 3);
  EXPECT_EQ((ValueInTwoSchemeOrders{1.0, 2.0}.agreed_significant_digits(7)), 1);
  EXPECT_EQ((ValueInTwoSchemeOrders{0.5, 0.5}.agreed_significant_digits(5)), 5);
  EXPECT_EQ((ValueInTwoSchemeOrders{0.0, 1e-9}.agreed_significant_digits(5)), 1);
  EXPECT_EQ((ValueInTwoSchemeOrders{0.0, 0.0}.agreed_significant_digits(5)), 1);
}

TEST(Reference, AgreesWithTheExactSolution) {
  const auto p = tests::make_problem({.cubic = 0, .restitution = 1});
  const auto r = compute_reference(p, {.refinement = 1.2, .simulation_time = 1e5});
  ASSERT_EQ(r.failure, "");
  const double y2 = exact::linear_cumulant(p, 2, 0);
  EXPECT_NEAR(r.moments.at(1).value.value_of_order_seven, y2, 1e-6 * y2);
  EXPECT_GE(r.moments.at(1).value.agreed_significant_digits(7), 5);
  const exact::LinearDensity exact(p);
  ASSERT_EQ(r.y.size(), 20u);
  ASSERT_EQ(r.ydot.size(), 20u);
  for (const auto& [y, density] : r.y) {
    const double edges[] = {y - 1e-4, y + 1e-4};
    EXPECT_NEAR(density.value_of_order_seven, exact.displacement_averages(edges)[0], 1e-5) << y;
  }
  for (const auto& [v, density] : r.ydot) {
    const double edges[] = {v - 1e-4, v + 1e-4};
    EXPECT_NEAR(density.value_of_order_seven, exact.velocity_averages(edges)[0], 1e-5) << v;
  }
}

TEST(ReferenceText, HasTheAgreedDigitsAlone) {
  CaseReferenceValues r{
      .problem = tests::paper_case(1), .failure = {}, .moments = {}, .y = {}, .ydot = {}};
  r.moments.push_back({"y2", "E[y^2]", {0.12345678, 0.12345679}, 0.1234, 1e-4});
  r.moments.push_back({"v4", "E[y'^4]", {55.26042, 55.26082}, 55.3, 0.05});
  r.y.push_back({0.25, {1.5e-5, 1.5e-5}});
  r.ydot.push_back({-0.5, {0.4, 0.4}});
  const std::string text = reference_markdown({r}, "fpkcheck reference");
  EXPECT_NE(text.find("| `E[y^2]` | 0.1234568 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| `E[y'^4]` | 55.260 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| 0.25 | 1.5000e-05 | -0.5 | 0.40000 |"), std::string::npos) << text;
  const std::string csv = reference_csv({r});
  EXPECT_NE(csv.find("test,y2,,0.12345678,1.0e-08\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("test,p_ydot,-0.5,0.4,0.0e+00\n"), std::string::npos) << csv;
}

TEST(ReferenceText, HasTheReasonWithoutAReference) {
  CaseReferenceValues r{.problem = tests::paper_case(1),
                        .failure = "the box is too small",
                        .moments = {},
                        .y = {},
                        .ydot = {}};
  const std::string text = reference_markdown({r}, "fpkcheck reference");
  EXPECT_NE(text.find("## test\n\nc = 0.1, k = 1, mu = 0.1, r = 0.98; gaussian impulses"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("No reference: the box is too small."), std::string::npos) << text;
  EXPECT_EQ(reference_csv({r}), "case,quantity,abscissa,value,uncertainty\n");
}

}  // namespace
}  // namespace fpkcheck::study
