#include "report/text/text_layout.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

std::vector<TextTableColumn> table() {
  std::vector<TextTableColumn> all{{"", "name", true, kAlwaysShown},
                                   make_status_column(),
                                   {"L1 to mcs", "p(y)", false, 2},
                                   {"L1 to mcs", "p(y')", false, 1}};
  const std::vector<std::vector<std::string>> cells{{"a", "ok", "0.1", "0.25"},
                                                    {"longer", "inadmissible", "12", "-"}};
  for (const auto& row : cells) {
    for (std::size_t c = 0; c < all.size(); ++c) all[c].cells.push_back(row[c]);
  }
  return all;
}

TEST(Columns, AreAlignedUnderTheirHeadersAndGroups) {
  EXPECT_EQ(format_text_table(table(), 100),
            "                       L1 to mcs\n"
            "name    status        p(y)  p(y')\n"
            "a       ok             0.1   0.25\n"
            "longer  inadmissible    12      -\n");
}

TEST(Columns, OfLeastImportanceGoWhereTheRowsDoNotFit) {
  const auto text = format_text_table(table(), 28);
  EXPECT_EQ(text.find("p(y')"), std::string::npos);
  EXPECT_NE(text.find("p(y)"), std::string::npos);
  EXPECT_NE(format_text_table(table(), 10).find("inadmissible"),
            std::string::npos);  // never omitted
}

// Without escape sequences the coloured table equals the plain table: widths count letters only.
TEST(Columns, AreColouredByStatusAndOtherwiseTheSame) {
  const auto plain = format_text_table(table(), 100),
             coloured = format_text_table(table(), {100, true});
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
  EXPECT_NE(coloured.find("\x1b[32mok"), std::string::npos);            // green
  EXPECT_NE(coloured.find("\x1b[33minadmissible"), std::string::npos);  // yellow
  std::string stripped;
  for (std::size_t k = 0; k < coloured.size(); ++k) {
    if (coloured[k] == '\x1b') {
      k = coloured.find('m', k);
    } else {
      stripped += coloured[k];
    }
  }
  EXPECT_EQ(stripped, plain);
}

}  // namespace
}  // namespace fpkcheck::report
