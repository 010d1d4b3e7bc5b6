#include "report/figure/text.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::report {
namespace {

TEST(FigureText, IsConvertedToLatex) {
  EXPECT_EQ(to_latex("{/:Italic p}({/:Italic y}')"), "$p$($y$')");
  EXPECT_EQ(to_latex("10^{-5} ≤ {/:Italic L}_1, log_{10}"),
            "10$^{-5}$ $\\le$ $L$$_{1}$, log$_{10}$");
  EXPECT_EQ(to_latex("λ E[Y²], 95 % |Δ|"), "$\\lambda$ E[Y$^2$], 95 \\% $|$$\\Delta$$|$");
  EXPECT_EQ(to_latex("10^{−5} × −2"), "10$^{-5}$ $\\times$ $-$2");
  EXPECT_EQ(to_latex("a -- b: --curves"), "a -{}- b: -{}-curves");
}

TEST(FigureText, HasNumbersWithMinusSigns) {
  EXPECT_EQ(scientific_text(-1.24e-6), "−1.2 × 10^{−6}");
  EXPECT_EQ(scientific_text(3e4), "+3.0 × 10^{4}");
  EXPECT_EQ(scientific_text(0), "0");
}

// A name may contain characters with a meaning in LaTeX.
TEST(FigureText, IsLiteralIfPlain) {
  EXPECT_EQ(gnuplot_literal("a_b"), "'a\\_b'");
  EXPECT_EQ(gnuplot_literal("\\input{x}$%#"),
            "say('\\\\input\\{x\\}$%#', '\\textbackslash{}input\\{x\\}\\$\\%\\#')");
  EXPECT_EQ(gnuplot_literal("it's"), "'it''s'");
}

TEST(FigureText, AcceptsAnIncompleteMark) {
  for (const char* text : {"a_", "a^{", "{/:Italic y", "a\\", "^"}) {
    EXPECT_NO_THROW(to_latex(text)) << text;
  }
}

TEST(Plot, VariablesAndDensitiesAreTypeset) {
  EXPECT_EQ(variable_text(transform::Variable::y), "y");
  EXPECT_EQ(density_text(transform::Variable::ydot), "p(y\u2032)");
}

}  // namespace
}  // namespace fpkcheck::report
