#include "report/figure/text.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(FigureText, IsWrittenForLatexAsLatexWantsIt) {
  EXPECT_EQ(latex_of("{/:Italic p}({/:Italic y}')"), "$p$($y$')");
  EXPECT_EQ(latex_of("10^{-5} ≤ {/:Italic L}_1, log_{10}"),
            "10$^{-5}$ $\\le$ $L$$_{1}$, log$_{10}$");
  EXPECT_EQ(latex_of("λ E[Y²], 95 % |Δ|"), "$\\lambda$ E[Y$^2$], 95 \\% $|$$\\Delta$$|$");
  EXPECT_EQ(latex_of("10^{−5} × −2"), "10$^{-5}$ $\\times$ $-$2");
  EXPECT_EQ(latex_of("a -- b: --curves"), "a -{}- b: -{}-curves");
}

TEST(FigureText, HasNumbersWithMinusSigns) {
  EXPECT_EQ(power_text(-1.24e-6), "−1.2 × 10^{−6}");
  EXPECT_EQ(power_text(3e4), "+3.0 × 10^{4}");
  EXPECT_EQ(power_text(0), "0");
}

// A name may contain characters with a meaning in LaTeX.
TEST(FigureText, ThatIsPlainIsSetLetterByLetter) {
  EXPECT_EQ(gnuplot_literal("a_b"), "'a\\_b'");
  EXPECT_EQ(gnuplot_literal("\\input{x}$%#"),
            "say('\\\\input\\{x\\}$%#', '\\textbackslash{}input\\{x\\}\\$\\%\\#')");
  EXPECT_EQ(gnuplot_literal("it's"), "'it''s'");
}

TEST(FigureText, ThatEndsWithinAMarkIsStillAText) {
  for (const char* text : {"a_", "a^{", "{/:Italic y", "a\\", "^"}) {
    EXPECT_NO_THROW(latex_of(text)) << text;
  }
}

}  // namespace
}  // namespace fpkcheck::report
