#include "report/figure/order_script.hpp"

#include <gtest/gtest.h>

#include "external_family.hpp"
#include "report/figure/pictures.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::contents;

TEST(OrderPicture, HasOneLineForEachFamilyByOrder) {
  const auto case_result = tests::case_with_external_family({6, 2});
  ASSERT_TRUE(has_several_orders(case_result));
  const std::string script = order_script(case_result, "case1-order", FigureWidth::screen);
  const auto begin = script.find("$y_family0 << EOD\n2 "), second = script.find("\n6 ", begin);
  EXPECT_NE(begin, std::string::npos);
  EXPECT_LT(second, script.find("EOD", begin + 20));
  EXPECT_TRUE(contains(script, "title 'chi'"));
  EXPECT_TRUE(contains(script, "title 'epc-gaussian'"));
  EXPECT_TRUE(contains(script, "$ydot_family0"));
}

TEST(OrderPicture, ExistsForAFamilyOfTwoOrders) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  results::Run run{results::this_program(""), {tests::case_with_external_family({2, 4, 6})}};
  const FigureOptions svg{.formats = {FigureFormat::svg}};
  const auto warnings = draw_pictures(directory.path(), run, svg);
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const auto picture = directory.path() / "figures" / "case1-order.svg";
  for (const char* text : {"(a) displacement", ">chi<", "open: not ok"}) {
    EXPECT_TRUE(contains(contents(picture), text)) << text;
  }
  for (auto& solution : run.cases[0].solutions) solution.identity.order.reset();
  draw_pictures(directory.path(), run, svg);
  EXPECT_FALSE(std::filesystem::exists(picture));
}

}  // namespace
}  // namespace fpkcheck::report
