#include "base/text/printable_text.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::base {
namespace {

TEST(Sanitise, KeepsPrintableText) {
  for (const char* text : {"", "case1", "it's", "p(y′), σ², 速度", "a\\b", "<b>&amp;</b>"}) {
    EXPECT_EQ(to_printable_text(text), text);
    EXPECT_EQ(to_single_line(text), text);
  }
  EXPECT_EQ(in_quotes("a b"), "'a b'");
}

TEST(Sanitise, EscapesControlCharacters) {
  EXPECT_EQ(to_printable_text("a\x1b[31mb\n\r\t\x7f"), "a\\x1b[31mb\\x0a\\x0d\\x09\\x7f");
  EXPECT_EQ(to_printable_text("\xc2\x9b"), "\\xc2\\x9b");           // CSI as one character
  EXPECT_EQ(to_printable_text("\xff\xc3"), "\\xff\\xc3");           // not UTF-8
  EXPECT_EQ(to_printable_text("\xc0\xaf"), "\\xc0\\xaf");           // overlong encoding
  EXPECT_EQ(to_printable_text("\xe2\x80\xae"), "\\xe2\\x80\\xae");  // right-to-left override
  EXPECT_EQ(to_printable_text(std::string_view("\0", 1)), "\\x00");
}

TEST(Sanitise, TruncatesTheMiddleOfLongText) {
  EXPECT_EQ(to_printable_text(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(to_printable_text(std::string(1000, 'x') + "end"),
            std::string(40, 'x') + "..." + std::string(34, 'x') + "end");
  EXPECT_LE(to_printable_text(std::string(100'000'000, '\x1b')).size(), 80u);
  // A long text is cut between two characters, not within a character.
  std::string greek;
  for (int k = 0; k < 100; ++k) greek += "λ";
  const std::string cut = to_printable_text(greek);
  EXPECT_EQ(escape_control_characters(cut), cut);
  EXPECT_LT(cut.size(), 170u);
}

TEST(ToSingleLine, RespectsTheLimitOfAnErrorLine) {
  EXPECT_EQ(to_single_line(std::string(1000, 'x')).size(), 380u);
  EXPECT_LE(to_single_line(std::string(1000, '\n')).size(), 380u);
  EXPECT_EQ(to_single_line("a\nb"), "a\\x0ab");
}

}  // namespace
}  // namespace fpkcheck::base
