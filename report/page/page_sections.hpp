#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "report/figure/heat_map_values.hpp"
#include "report/report_supplement.hpp"
#include "report/verdict/verdict.hpp"
#include "results/run.hpp"

/// The parts of the report page as HTML, and the data of its heat maps as JSON.

namespace fpkcheck::report {

/// Returns the description of the problem of a run in words and formulas, with its parameters. A
/// sentence states the parameters that all cases share, and a table shows the parameters that vary
/// between cases.
std::string problem_description_html(const results::Run& run);

/// Returns the parameters of a case that differ between the cases of the run, as text: "μ = 1,
/// λE[Y²] = 0.1".
std::string varying_parameters_text(const results::Run& run,
                                    const results::CaseResult& case_result);

/// Returns the glossary of all solutions, equations, impact conditions, columns and statuses that
/// occur in a run.
std::string glossary_html(const results::Run& run);

/// Returns the HTML table of the wall-clock times of each solution in each case, in seconds.
std::string timings_table_html(const results::Run& run);

/// Returns the description of problems in words, and their equation of motion. The equation of
/// motion has every term that occurs in at least one of the problems.
/// @param problems at least one problem
std::string problem_statement(std::span<const problem::Problem* const> problems);

std::string verdict_paragraph_html(const std::string& sentence);

/// Returns the verdict, the first section of the report page: the main result, a matrix and a
/// picture of the L1 distances, the outcome of each method, and the recommendation.
/// @param anchors ids of the sections of the cases, in the order of the cases
std::string verdict_html(const results::Run& run, const std::vector<std::string>& anchors);

/// Returns an SVG picture of the L1 distances from the reference solution, with one row for each
/// solution and one mark for each case. The position of a mark on the logarithmic axis is the
/// larger L1 distance of p(y) and p(y') from the reference. A line marks the L1 distance
/// compare::kCloseL1, and a rectangle covers L1 distances below the error estimate of the reference
/// solutions. The SVG picture is empty if the run has no distances from a reference solution.
std::string reference_distance_plot_svg(
    const results::Run& run, const std::vector<SolutionAgreementOverCases>& agreement_rows);

/// Returns the HTML table of the solutions of a case. The table row of a solution has the equation
/// and impact condition, status, moments, distances from the solutions of the full problem, mass,
/// energy residual and wall-clock time.
std::string solutions_table_html(const results::CaseResult& case_result);

/// Returns the table of errors of those moments that are outside the guaranteed bounds. The error
/// of a moment is the distance of the moment from the midpoint of its bounds, with the half-width
/// of the bounds as uncertainty. Without guaranteed bounds the table of moment errors is empty.
std::string guaranteed_bound_errors_table_html(const results::CaseResult& case_result);

/// Returns the table of the residual-based error estimates of moments, or an empty text without
/// estimates.
std::string residual_errors_table_html(const results::CaseResult& case_result);

/// Returns HTML with the reason for each status of a solution other than `ok`. The HTML text is
/// empty if all solutions of the case have the status `ok`.
std::string status_reasons_html(const results::CaseResult& case_result);

/// Returns the tables of diagnostics. The first table of diagnostics has the mass, energy residual,
/// error estimates and sampling errors of all solutions. Each further table of diagnostics has the
/// metrics of one family of methods.
std::string diagnostics_tables_html(const results::CaseResult& case_result);

/// Returns tables of metrics, which are numbers that solvers report on their solutions. The metric
/// table of a family of methods has a column for each solution and a row for each metric. In a
/// table of metrics, grouped metrics such as "support.edge_density" follow all other metrics. The
/// tables of metrics omit lists (coefficients, quantiles), metrics without a value in the family,
/// and metrics that repeat an option.
std::string metric_tables_html(const results::CaseResult& case_result);

/// Returns a paragraph that explains the figure and tables of the error budget, and names the
/// reference of the total distances. The introduction to the error budget is empty if the case has
/// no error budget.
std::string error_budget_introduction_html(const results::CaseResult& case_result);

/// Returns HTML tables of the L1 distances and the tail distances in the error budget.
std::string error_budget_tables_html(const results::CaseResult& case_result);

/// The difference between the joint density of a solution and the joint density of the reference
/// solution.
struct JointDensityDifference {
  std::string solution;  ///< id of the solution
  double l1;             ///< L1 distance from the reference over all common cells, including atoms
  QuantisedSignedRoots
      values;  ///< cell differences in the order of JointDensityHeatMaps::reference_density
};

/// The joint densities of a case on those common cells in which the reference density is large
/// enough to be shown.
struct JointDensityHeatMaps {
  std::string reference;        ///< id of the reference
  std::vector<double> y_edges;  ///< ny + 1 cell edges in y
  std::vector<double> v_edges;  ///< nv + 1 cell edges in y'
  /// Joint density of the reference solution in rows of constant y', with the shape (nv, ny).
  std::vector<double> reference_density;
  std::array<double, 2> y_bulk, v_bulk;  ///< ranges in which the reference exceeds peak/500
  std::vector<JointDensityDifference>
      differences;  ///< closures (closest first), then all other solutions
};

/// @return the joint densities on the common cells; empty if the case has no reference solution, or
///         no other `ok` solution
std::optional<JointDensityHeatMaps> make_joint_density_maps(const results::CaseResult& case_result);

/// Returns the HTML elements in which page.js draws the heat maps of joint densities.
std::string joint_density_maps_html(const JointDensityHeatMaps& maps, const std::string& prefix);

/// Returns the heat maps of joint densities as JSON, the input of the script page.js.
std::string joint_density_maps_json(const JointDensityHeatMaps& maps, const std::string& prefix);

/// Returns the HTML elements of the heat maps of a figure: a control that selects the shown maps,
/// and a place for each shown map. The script page.js draws the heat maps in their HTML elements.
/// @param prefix text before the ids of the heat maps
/// @param label label of the control
/// @param introduction HTML between the control and the maps
/// @pre the figure has at least one panel
std::string heat_maps_html(const Figure& figure, const std::string& prefix,
                           const std::string& label, const std::string& introduction);

/// Returns the heat maps of a figure as JSON, the input of the script page.js.
/// @pre all heat maps have cells, and their values are signed square roots from -1 to 1
std::string heat_maps_json(const Figure& figure, const std::string& prefix);

/// Returns the self-contained page report.html, which needs no other file and no network. The page
/// report.html contains the verdict, the problem, one section for each case, the timings and the
/// command of the run. The report section of a case has densities, results, findings, error budget,
/// convergence, joint densities and diagnostics. The report page omits data that the run did not
/// save.
/// @param supplement texts that a command adds to the page. The summary of the supplement is at the
///        top of the page, and its sections precede the description of the problem.
std::string report_page_html(const results::Run& run, const ReportSupplement& supplement = {});

}  // namespace fpkcheck::report
