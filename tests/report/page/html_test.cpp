#include "report/page/html.hpp"

#include <gtest/gtest.h>

#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

TEST(Html, EscapesWhatHasAMeaningThere) {
  EXPECT_EQ(escape_html("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
  EXPECT_EQ(html_element("p", "1 < 2"), "<p>1 &lt; 2</p>\n");
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

TEST(Html, ShowsAStatusAsAChip) {
  HtmlColumn status{"status", Align::left, {"ok", "x < y"}};
  status.is_status = true;
  const std::string html = table_html("T", {{"name", Align::left, {"a", "b"}}, status});
  EXPECT_TRUE(contains(html, "<td><span class=\"chip ok\">ok</span></td>")) << html;
  EXPECT_TRUE(contains(html, "x &lt; y</span>")) << html;
}

TEST(Html, FoldsWhatIsThere) {
  EXPECT_EQ(details_html("a", "1 < 2", "<p>"),
            "<details id=\"a\">\n<summary>1 &lt; 2</summary>\n<p></details>\n");
  EXPECT_EQ(details_html("a", "b", ""), "");
}

TEST(Html, NamesAloneAreNoTable) {
  const std::string none(kNoValue);
  EXPECT_EQ(table_html("T", {{"name", Align::left, {"a"}}, {"empty", Align::right, {none}}}), "");
}

}  // namespace
}  // namespace fpkcheck::report
