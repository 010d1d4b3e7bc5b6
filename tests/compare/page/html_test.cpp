#include "compare/page/html.hpp"

#include <gtest/gtest.h>

#include "compare/page/number_text.hpp"
#include "compare/page/typed_array.hpp"
#include "saved_run.hpp"

namespace fpkcheck::compare {
namespace {

using tests::contains;

TEST(Html, EscapesWhatHasAMeaningThere) {
  EXPECT_EQ(escaped("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(element("p", "1 < 2"), "<p>1 &lt; 2</p>\n");
  EXPECT_EQ(inside_script(R"(["</script>"])"), R"(["\u003c/script>"])");
}

TEST(Html, ATableNamesItsRowsAndDropsColumnsWithoutAValue) {
  const std::string none(kNoValue);
  const std::string html = table_html("T & T", {{"name", Align::left, {"a", "b"}},
                                                {"empty", Align::right, {none, none}},
                                                {"value", Align::right, {"1", none}}});
  EXPECT_TRUE(contains(html, "<caption>T &amp; T</caption>"));
  EXPECT_TRUE(contains(html, "<th scope=\"row\">a</th><td class=\"number\">1</td>"));
  EXPECT_TRUE(contains(html, "<th scope=\"row\">b</th><td class=\"number\">\u2013</td>"));
  EXPECT_FALSE(contains(html, "empty"));
  EXPECT_EQ(table_html("nothing", {{"name", Align::left, {}}}), "");
}

TEST(Html, NamesAloneAreNoTable) {
  const std::string none(kNoValue);
  EXPECT_EQ(table_html("T", {{"name", Align::left, {"a"}}, {"empty", Align::right, {none}}}), "");
}

TEST(NumberText, KeepsItsDigitsAndHasTheTerminalsDistances) {
  EXPECT_EQ(number_text(0.445, 4), "0.4450");
  EXPECT_EQ(number_text(4.34, 4), "4.340");
  EXPECT_EQ(number_text(6e-5, 2), "6.0e-5");
  EXPECT_EQ(number_text(150, 3), "150");
  EXPECT_EQ(number_text(0.0004, 1), "4e-4");
  EXPECT_EQ(plain_text(0.1), "0.1");
  EXPECT_EQ(plain_text(12), "12");
  EXPECT_EQ(plain_text({}), kNoValue);
  EXPECT_EQ(l1_cell(0.03), "0.03000");
  EXPECT_EQ(l1_cell(0.0044), "0.00440");
  EXPECT_EQ(l1_cell(6e-6), "6e-6");
  EXPECT_EQ(l1_cell({}), kNoValue);
}

TEST(NumberText, IsShort) {
  EXPECT_EQ(number_text(0.39450001, 4), "0.3945");
  EXPECT_EQ(number_text(-1.234e-5, 2), "-1.2e-5");
  EXPECT_EQ(number_text(1.2e-12, 2), "1.2e-12");
  EXPECT_EQ(number_text(2.98e6, 3), "2.98e6");
  EXPECT_EQ(number_text(1e10, 1), "1e10");
  EXPECT_EQ(number_text(0, 2), "0");
  EXPECT_EQ(number_text({}, 2), kNoValue);
  EXPECT_EQ(seconds_text(0.00421), "0.0042");
  EXPECT_EQ(seconds_text(16.93), "16.9");
  EXPECT_EQ(seconds_text(130.4), "130");
}

TEST(TypedArray, IsLittleEndianBase64) {
  // 1.0f is 00 00 80 3f, -2.0f is 00 00 00 c0.
  EXPECT_EQ(float_array(std::vector{1.0}).at("bdata"), "AACAPw==");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0}).at("bdata"), "AACAPwAAAMA=");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0, 1.0}).at("bdata"), "AACAPwAAAMAAAIA/");
  EXPECT_EQ(float_array(std::vector{1.0}).at("dtype"), "f4");
  EXPECT_EQ(integer_array(std::vector<std::int16_t>{1, -2}).at("bdata"), "AQD+/w==");
}

}  // namespace
}  // namespace fpkcheck::compare
