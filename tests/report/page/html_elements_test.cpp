#include "report/page/html_elements.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "gunzip_base64.hpp"
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
  const std::string html = table_html("T & T", {{"name", TextAlignment::left, {"a", "b"}},
                                                {"empty", TextAlignment::right, {none, none}},
                                                {"value", TextAlignment::right, {"1", none}}});
  EXPECT_TRUE(contains(html, "<caption>T &amp; T</caption>"));
  EXPECT_TRUE(contains(html, "<th scope=\"row\">a</th><td class=\"number\">1</td>"));
  EXPECT_TRUE(contains(html, "<th scope=\"row\">b</th><td class=\"number\">\u2013</td>"));
  EXPECT_FALSE(contains(html, "empty"));
  EXPECT_EQ(table_html("nothing", {{"name", TextAlignment::left, {}}}), "");
}

TEST(Html, ShowsAStatusAsAChip) {
  HtmlTableColumn status{"status", TextAlignment::left, {"ok", "x < y"}};
  status.is_status = true;
  const std::string html = table_html("T", {{"name", TextAlignment::left, {"a", "b"}}, status});
  EXPECT_TRUE(contains(html, "<td><span class=\"chip ok\">ok</span></td>")) << html;
  EXPECT_TRUE(contains(html, "x &lt; y</span>")) << html;
}

TEST(Html, FoldsWhatIsThere) {
  EXPECT_EQ(collapsible_html("a", "1 < 2", "<p>"),
            "<details id=\"a\">\n<summary>1 &lt; 2</summary>\n<p></details>\n");
  EXPECT_EQ(collapsible_html("a", "b", ""), "");
}

TEST(Html, NamesAloneAreNoTable) {
  const std::string none(kNoValue);
  EXPECT_EQ(table_html("T", {{"name", TextAlignment::left, {"a"}},
                             {"empty", TextAlignment::right, {none}}}),
            "");
}

std::string encoded(const std::string& text) {
  return encode_base64(std::as_bytes(std::span(text)));
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("\xff\xfe"), "//4=");
}

TEST(Gzip, IsUnpackedUnchanged) {
  for (const std::size_t size : {0, 1, 2, 3, 100'000}) {
    std::string text;
    for (std::size_t k = 0; k < size; ++k) text += static_cast<char>(k * k % 251);
    EXPECT_EQ(tests::gunzip_base64(gzip_base64(text)), text) << size;
  }
}

TEST(Gzip, OfTheSameTextIsTheSameAndSmaller) {
  const std::string text(10'000, 'x');
  EXPECT_EQ(gzip_base64(text), gzip_base64(text));
  EXPECT_LT(gzip_base64(text).size(), 200u);
}

TEST(TypedArray, IsLittleEndianBase64) {
  // 1.0f is 00 00 80 3f, -2.0f is 00 00 00 c0.
  EXPECT_EQ(encode_float_array(std::vector{1.0}).bdata, "AACAPw==");
  EXPECT_EQ(encode_float_array(std::vector{1.0, -2.0}).bdata, "AACAPwAAAMA=");
  EXPECT_EQ(encode_float_array(std::vector{1.0, -2.0, 1.0}).bdata, "AACAPwAAAMAAAIA/");
}

TEST(TypedArray, NamesItsTypeInJson) {
  EXPECT_EQ(nlohmann::ordered_json(encode_float_array(std::vector{1.0})).dump(),
            R"({"dtype":"f4","bdata":"AACAPw=="})");
}

TEST(PageParts, AreTheFilesWhole) {
  EXPECT_TRUE(page_template().starts_with("<!doctype html>"));
  EXPECT_TRUE(page_template().ends_with("</html>\n"));
  EXPECT_NE(page_style().find("@media print"), std::string::npos);
  EXPECT_NE(page_script().find("'drawn'"), std::string::npos);
  EXPECT_GT(plotly_script().size(), 500'000u);
}

TEST(PageParts, TheFrameHasAPlaceForEach) {
  for (const std::string place : {"title", "style", "body", "plots", "plotly", "script"}) {
    EXPECT_NE(page_template().find("{{" + place + "}}"), std::string::npos) << place;
  }
}

}  // namespace
}  // namespace fpkcheck::report
