#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "general_oscillators.hpp"
#include "modified_case.hpp"
#include "problem/case_file.hpp"
#include "report/case_solutions.hpp"
#include "report/page/page_sections.hpp"
#include "report/terminal_tables.hpp"
#include "results/run_assessment.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::collapse_whitespace;
using tests::contains;
using tests::made_up_case;
using tests::solution_of;

std::string statement(const problem::Problem& problem) {
  const problem::Problem* const problems[] = {&problem};
  return problem_statement(problems);
}

TEST(ProblemStatement, HasTheTermsThatTheProblemHas) {
  const auto ring = statement(tests::with_noise(
      problem::System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1},
                      {.none = true}),
      0.4));
  EXPECT_TRUE(contains(
      ring, "y″ + (c + c<sub>yy</sub> y² + c<sub>vv</sub> y′²) y′ + k y = √(2D) W(t).</p>"));
  EXPECT_TRUE(contains(ring, "without walls, under white noise"));
  EXPECT_FALSE(contains(ring, "Poisson"));
  const auto box = statement(tests::with_impulses(
      problem::System({.constant = 1},
                      {.left = -1, .left_restitution = 0.7, .right = 1, .right_restitution = 0.9}),
      tests::gaussian_impulses(1, 1)));
  EXPECT_TRUE(contains(box, "y″ + g₀ = Σ")) << box;
  EXPECT_TRUE(contains(box, "for a &lt; y &lt; b"));
  EXPECT_TRUE(contains(box, "r<sub>b</sub>"));
}

problem::Problem problem_of(const std::string& ini) {
  std::istringstream in(ini);
  return problem::read_case(in, "own", "own.ini");
}

TEST(ProblemStatement, TypesetsTheFormulasOfForceNoiseAndImpact) {
  const auto text = statement(
      problem_of("[system]\nforce = c*v*abs(v) + 1e-3*y^(2*n) + y^-2*sqrt(1+y^2) + y^3^c\n"
                 "[parameters]\nc = 1\nn = 1\n[noise]\nintensity = 0.2\n"
                 "factor = sqrt(1 + v^2)\ninterpretation = ito\n"
                 "[wall]\nleft = 0.5\nleft_restitution = 1 - 0.3*min(1, v)^0.2\n"));
  EXPECT_TRUE(contains(text,
                       "y″ + c·y′·|y′| + 1e-3·y<sup>2·n</sup> + y<sup>−2</sup>·√(1+y<sup>2"
                       "</sup>) + y<sup>3<sup>c</sup></sup> = √(2D) g(y, y′) W(t)"))
      << text;
  EXPECT_TRUE(contains(text, "g(y, y′) = √(1 + y′<sup>2</sup>) &emsp; (in the sense of Itô)"))
      << text;
  EXPECT_TRUE(contains(text, "y′<sub>+</sub> = −r<sub>a</sub>(u) y′<sub>−</sub> &nbsp; at y = a"));
  EXPECT_TRUE(contains(text, "r<sub>a</sub>(u) = 1 − 0.3·min(1, u)<sup>0.2</sup>")) << text;
}

// A formula with the terms of the paper's oscillator: the statement shows the formula, since the
// parameters c, k and mu have no values.
TEST(ProblemStatement, ShowsTheFormulaOfThePapersOscillator) {
  const auto text =
      statement(problem_of("[system]\nforce = 0.1*v + y\nrestitution = 0.9\n[impulse]\nrate = 1\n"
                           "law = gaussian\nintensity = 1\n"));
  EXPECT_TRUE(contains(text, "y″ + 0.1·y′ + y = Σ")) << text;
  EXPECT_TRUE(contains(text, "−r y′<sub>−</sub> &nbsp; at y = 0")) << text;
}

TEST(ProblemStatement, OfTheBaseClassIsThatOfThePaper) {
  EXPECT_TRUE(contains(statement(tests::paper_case(1)), "on a hardening spring"));
}

results::CaseResult with_not_offered() {
  results::CaseResult case_result = made_up_case();
  for (const char* id : {"fd-white", "fd-kf"}) {
    auto& solution = solution_of(case_result, id);
    solution.status = transform::Status::not_offered;
    solution.reason = "this wall is not supported";
    solution.density.reset();
  }
  case_result.update_assessment();
  return case_result;
}

TEST(Table, UnsupportedMethodsWithEqualReasonsShareALine) {
  const auto case_result = with_not_offered();
  const std::string text = collapse_whitespace(
      terminal_tables_text({results::current_program("fpkcheck run"), {case_result}}));
  EXPECT_TRUE(contains(text, "fd-white, fd-kf not_offered: this wall is not supported")) << text;
  EXPECT_FALSE(contains(text, "fd-white white/map")) << text;  // no row
  EXPECT_TRUE(contains(status_reasons_html(case_result), "fd-white, fd-kf not_offered"));
}

TEST(Verdict, OmitsMethodsThatApplyToNoCase) {
  const auto row_count = [](const std::vector<results::CaseResult>& cases) {
    const results::Run run{results::current_program("fpkcheck run"), cases};
    return results::assess_run(run).rows.size();
  };
  const auto all = row_count({made_up_case()});
  EXPECT_EQ(row_count({with_not_offered()}) + 2, all);
  EXPECT_EQ(row_count({made_up_case(), with_not_offered()}), all);
}

TEST(Table, HasTheProbabilityOfRestAtEachWall) {
  results::CaseResult case_result = made_up_case();
  solution_of(case_result, "fd-kf").atoms = {{.y = -0.5, .probability = 0.25}};
  EXPECT_EQ(walls_with_rest_atoms(case_result), std::vector<double>{-0.5});
  EXPECT_TRUE(contains(
      terminal_tables_text({results::current_program("fpkcheck run"), {case_result}}), "P(rest)"));
  EXPECT_TRUE(contains(solutions_table_html(case_result), "0.25"));
  solution_of(case_result, "mcs").atoms = {{.y = 0.5, .probability = 0.125}};
  EXPECT_EQ(rest_probability_header(case_result, 0.5), "P(rest at 0.5)");
  EXPECT_EQ(rest_atom_probability(solution_of(case_result, "mcs"), 0.5), 0.125);
  EXPECT_TRUE(std::isnan(rest_atom_probability(solution_of(case_result, "mcs"), -0.5)));
}

}  // namespace
}  // namespace fpkcheck::report
