#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "workflows/study/reference/reference.hpp"

namespace fpkcheck::study {
namespace {

TEST(ReferenceText, HasTheAgreedDigitsAlone) {
  Reference r{.problem = tests::paper_case(1), .failure = {}, .moments = {}, .y = {}, .ydot = {}};
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
  Reference r{.problem = tests::paper_case(1),
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
