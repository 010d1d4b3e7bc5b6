#include <gtest/gtest.h>

#include <cmath>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "gunzip_base64.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "report/terminal_tables.hpp"
#include "report/write_report.hpp"
#include "results/run.hpp"
#include "results/saved_run.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"
#include "transform/marginal_density.hpp"
#include "workflows/check/baseline.hpp"
#include "workflows/check/compare_runs.hpp"
#include "workflows/study/closure_order_study.hpp"

/// A method from outside the source tree. Its registry entry alone adds the method to every table,
/// figure and file, to the error budget, the study of orders and the regression test.
namespace fpkcheck {
namespace {

using tests::contains;

struct Bell {
  int order = 2;
  double stretch = 1;
};

const base::OptionsDescription<Bell>& bell_description() {
  static const auto description =
      base::OptionsDescription<Bell>("bell ")
          .add("order", &Bell::order, {"N", "the higher, the narrower"},
               base::even_integers_between(2, 8))
          .add("stretch", &Bell::stretch, {"S", "in y"}, base::positive_numbers());
  return description;
}

transform::SolutionIdentity bell_identity(const Bell& bell) {
  return {.id = "toy-bell-n" + std::to_string(bell.order),
          .method = "toy",
          .formulation = "bell",
          .order = bell.order,
          .equation = problem::DensityEquation::kf,
          .impact = problem::ImpactCondition::map};
}

std::optional<Bell> bell_of(std::string_view id) {
  for (const int order : {2, 4, 6, 8}) {
    if (id == bell_identity({.order = order}).id) return Bell{.order = order};
  }
  return std::nullopt;
}

// The Gaussian of equivalent linearisation, slightly narrower with each order.
transform::Solution solve_bell(const problem::Problem& problem, const Bell& bell) {
  const auto linear = problem::equivalent_linearisation(problem);
  const double shrink = 1 - 0.005 * bell.order;
  const double a = linear.displacement_deviation * shrink * bell.stretch,
               b = linear.velocity_deviation * shrink;
  transform::SmoothDensity density{[=](double y, double v) {
                                     return std::exp(-y * y / (2 * a * a) - v * v / (2 * b * b)) /
                                            (M_PI * a * b);
                                   },
                                   8 * a, 8 * b};
  transform::Solution solution{.identity = bell_identity(bell)};
  solution.status = transform::Status::ok;
  const auto marginals =
      transform::marginals_at_quadrature_points(density, density.y_max, density.v_max);
  solution.moments = marginals.moments;
  solution.mass = marginals.mass;
  solution.density = density;
  solution.metrics = transform::SolverMetricsBuilder()
                         .add_result_metric("width.y", a)
                         .add_result_metric("width.ydot", b)
                         .add_diagnostic_metric("strokes", std::int64_t{1})
                         .take_metrics();
  return solution;
}

methods::Solver toy_solver() {
  methods::Solver entry{.name = "toy",
                        .summary = "a bell",
                        .usage = "usage: fpkcheck toy CASE",
                        .families = {{.name = "toy-bell",
                                      .role = transform::SolutionRole::closure,
                                      .meaning = "A bell of about the right width.",
                                      .default_ids = {"toy-bell-n2", "toy-bell-n4"},
                                      .plot_style = [](const transform::SolutionIdentity&) {
                                        return transform::PlotStyle{.colour = "#12AB34",
                                                                    .dash = "(1,1)"};
                                      }}}};
  return methods::registry_entry_with_solver_traits<Bell>(
      std::move(entry),
      {.description = bell_description(),
       .validate = [](const Bell& bell) { bell_description().validate(bell); },
       .identity = bell_identity,
       .options_of = bell_of,
       .solve = [](const problem::Problem& problem, const Bell& bell,
                   const methods::SolverInputContext&) { return solve_bell(problem, bell); }});
}

methods::SolverRegistry with_toy() {
  methods::SolverRegistry registry = methods::builtin_registry();
  registry.add_solver(toy_solver());
  return registry;
}

class ToyClosure : public testing::Test {
 protected:
  // Solved once for all tests of a process.
  static const results::Run& solved_run() {
    static const results::Run run{
        results::current_program("fpkcheck run"),
        methods::run_cases({tests::paper_case(1)},
                           with_toy().methods_selected_by_list("toy,epc-gaussian-n2,fd-kf", {}), 1,
                           {})};
    return run;
  }

  const methods::SolverRegistry registry_ = with_toy();
  const results::Run& run_ = solved_run();
  const results::CaseResult& case_ = run_.cases.front();
};

TEST_F(ToyClosure, IsOrderedAmongTheClosures) {
  std::string ids;
  for (const auto& solution : case_.solutions) ids += solution.id() + ' ';
  EXPECT_EQ(ids, "epc-gaussian-n2 toy-bell-n2 toy-bell-n4 fd-kf ");
}

TEST_F(ToyClosure, AppearsInTableFindingsAndErrorBudget) {
  const std::string table = report::terminal_tables_text(run_);
  EXPECT_TRUE(contains(table, "toy-bell-n2")) << table;
  EXPECT_TRUE(contains(table, "kf/map")) << table;
  ASSERT_EQ(case_.budget.size(), 6u);
  EXPECT_EQ(case_.budget[2].solution, "toy-bell-n2");
  EXPECT_EQ(case_.budget[2].parts.front().error_budget_part_name(), "closure");
  const std::string limits = results::limiting_errors_text(case_);
  EXPECT_TRUE(contains(limits, "toy-bell-n2 and -n4")) << limits;
}

TEST_F(ToyClosure, AppearsInFilesFiguresAndPageWithItsStyle) {
  const tests::TemporaryDirectory directory;
  report::write_report(directory.path(), run_);
  const auto read = [&](const char* file) { return tests::contents(directory.path() / file); };
  EXPECT_TRUE(contains(read("summary.json"), "\"width\": {"));
  EXPECT_TRUE(contains(read("marginals.csv"), "test,toy-bell-n4,ydot,"));
  EXPECT_TRUE(contains(read("figures/test.gp"), "#12AB34"));
  const std::string page = read("report.html");
  EXPECT_TRUE(contains(page, "toy-bell-n2"));
  const std::string opening = "id=\"plots\">";
  const auto plots = page.find(opening) + opening.size();
  EXPECT_TRUE(
      contains(tests::gunzip_base64(page.substr(plots, page.find('<', plots) - plots)), "#12AB34"));
  EXPECT_TRUE(contains(page, "A bell of about the right width."));
}

TEST_F(ToyClosure, AppearsInTheStudyOfOrders) {
  const auto names = study::closure_formulations(registry_);
  EXPECT_NE(std::ranges::find(names, "toy-bell"), names.end());
  const auto found =
      study::study_closure_orders(tests::paper_case(1), {{"toy-bell"}, {2, 4, 6}}, registry_, {});
  const auto output = study::make_study_report(found, "fpkcheck study", {});
  EXPECT_TRUE(contains(output.csv, "\ntoy-bell,6,ok,")) << output.csv;
}

TEST_F(ToyClosure, IsCheckedForChanges) {
  const tests::TemporaryDirectory directory;
  base::FileTransaction files;
  results::add_run_files(files, directory.path(), run_);
  files.commit();
  const auto baseline = check::load_baseline(directory.path(), registry_, {});
  auto again = check::repeat_baseline_run(baseline, "fpkcheck check", 1, {});
  EXPECT_TRUE(check::compare_runs(baseline.run, again, {}).agrees_with_baseline());
  auto& width = again.cases[0].solutions[1].metrics[0];
  ASSERT_EQ(width.path, "width.y");
  width.value = std::get<double>(width.value) * (1 + 1e-6);
  const auto moved = check::compare_runs(baseline.run, again, {}).quantities_beyond_tolerance();
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].solution, "toy-bell-n2");
  // Without the registry entry the solution cannot be solved again.
  EXPECT_THROW(check::load_baseline(directory.path(), methods::builtin_registry(), {}), InputError);
}

TEST_F(ToyClosure, HasACommandWithItsOptions) {
  const auto* solver = registry_.find_solver("toy");
  ASSERT_NE(solver, nullptr);
  auto options = solver->default_options;
  options[0].value = std::int64_t{3};
  EXPECT_THROW(registry_.make_method(*solver, options), InputError);
  options[0].value = std::int64_t{8};
  EXPECT_EQ(registry_.make_method(*solver, options).id(), "toy-bell-n8");
}

}  // namespace
}  // namespace fpkcheck
