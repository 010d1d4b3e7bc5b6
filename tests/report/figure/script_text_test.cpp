#include "report/figure/script_text.hpp"

#include <gtest/gtest.h>

#include <set>

namespace fpkcheck::report {
namespace {

TEST(ScriptParts, EveryShapeIsFilledOrOpen) {
  std::set<int> types;
  for (const char* symbol :
       {"circle", "square", "triangle-up", "triangle-down", "diamond", "pentagon", "anything"}) {
    const auto [filled, open] = gnuplot_point_types(symbol);
    EXPECT_TRUE(types.insert(filled).second) << symbol;
    EXPECT_TRUE(types.insert(open).second) << symbol;
  }
}

TEST(ScriptParts, PartsAreLinesOfAScript) {
  EXPECT_EQ(gnuplot_data_block("a", "1 2\n"), "$a << EOD\n1 2\nEOD\n");
  EXPECT_EQ(panel_position_commands({0.1, 0.9, 0.8, 0.2}),
            "set lmargin at screen 0.1\nset rmargin at screen 0.9\n"
            "set tmargin at screen 0.8\nset bmargin at screen 0.2\n");
}

TEST(FigureText, IsConvertedToLatex) {
  EXPECT_EQ(enhanced_text_to_latex("{/:Italic p}({/:Italic y}')"), "$p$($y$')");
  EXPECT_EQ(enhanced_text_to_latex("10^{-5} ≤ {/:Italic L}_1, log_{10}"),
            "10$^{-5}$ $\\le$ $L$$_{1}$, log$_{10}$");
  EXPECT_EQ(enhanced_text_to_latex("λ E[Y²], 95 % |Δ|"),
            "$\\lambda$ E[Y$^2$], 95 \\% $|$$\\Delta$$|$");
  EXPECT_EQ(enhanced_text_to_latex("10^{−5} × −2"), "10$^{-5}$ $\\times$ $-$2");
  EXPECT_EQ(enhanced_text_to_latex("a -- b: --curves"), "a -{}- b: -{}-curves");
}

TEST(FigureText, HasNumbersWithMinusSigns) {
  EXPECT_EQ(scientific_notation_text(-1.24e-6), "−1.2 × 10^{−6}");
  EXPECT_EQ(scientific_notation_text(3e4), "+3.0 × 10^{4}");
  EXPECT_EQ(scientific_notation_text(0), "0");
}

// A name may contain characters with a meaning in LaTeX.
TEST(FigureText, IsLiteralIfPlain) {
  EXPECT_EQ(literal_gnuplot_expression("a_b"), "'a\\_b'");
  EXPECT_EQ(literal_gnuplot_expression("\\input{x}$%#"),
            "say('\\\\input\\{x\\}$%#', '\\textbackslash{}input\\{x\\}\\$\\%\\#')");
  EXPECT_EQ(literal_gnuplot_expression("it's"), "'it''s'");
}

TEST(FigureText, AcceptsAnIncompleteMark) {
  for (const char* text : {"a_", "a^{", "{/:Italic y", "a\\", "^"}) {
    EXPECT_NO_THROW(enhanced_text_to_latex(text)) << text;
  }
}

TEST(Plot, VariablesAndDensitiesAreTypeset) {
  EXPECT_EQ(variable_in_plain_text(transform::StateVariable::y), "y");
  EXPECT_EQ(density_in_plain_text(transform::StateVariable::ydot), "p(y\u2032)");
}

}  // namespace
}  // namespace fpkcheck::report
