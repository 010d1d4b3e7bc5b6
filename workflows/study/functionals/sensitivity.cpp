#include "workflows/study/functionals/functionals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/input_error.hpp"
#include "compare/comparison_bins.hpp"
#include "epc/sensitivities.hpp"
#include "fd_fpk/functionals/sensitivities.hpp"
#include "mcs/sensitivities.hpp"
#include "problem/parameter_derivative.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"

namespace fpkcheck::study {
namespace {

using transform::ExpectationDerivatives;
using transform::MarginalDerivatives;
using transform::MomentSensitivities;

// Steps of the difference quotients, relative to the parameter. The quotients of the matrix of the
// finite volumes have errors of about 1e-8; a simulation needs a step that changes the moments by
// more than its rounding errors and by less than a tenth.
constexpr double kMatrixStep = 1e-4, kClosureStep = 1e-3, kSimulationStep = 0.02;

std::vector<std::string> selected_parameters(const problem::Problem& problem,
                                             const SensitivityOptions& options) {
  if (!options.parameters) return problem::differentiable_parameters(problem);
  const std::vector<std::string> keys = split_at_commas(*options.parameters);
  if (keys.empty()) throw InputError("--parameters: empty list; omit the option for all numbers");
  return keys;
}

double elasticity(const MomentSensitivities& s, const ExpectationDerivatives& one, std::size_t k) {
  // A mean that is 0 by symmetry has no elasticity.
  constexpr double kSmallestMean = 1e-2;  // in root mean squares
  const auto square =
      std::ranges::find(s.expectations, "E[y^2]", &ExpectationDerivatives::expectation);
  const bool is_zero = one.expectation == "E[y]" && square != s.expectations.end() &&
                       std::abs(one.value) < kSmallestMean * std::sqrt(square->value);
  return is_zero ? std::numeric_limits<double>::quiet_NaN()
                 : one.derivatives[k] * s.parameter_values[k] / one.value;
}
double elasticity_error_estimate(const MomentSensitivities& s, const ExpectationDerivatives& one,
                                 std::size_t k) {
  return std::abs(one.errors[k] * s.parameter_values[k] / one.value);
}

std::string density_symbol(transform::StateVariable variable) {
  return variable == transform::StateVariable::y ? "p(y)" : "p(y')";
}

bool has_derivatives(const MomentSensitivities& s) { return !s.expectations.empty(); }

// Changes the status `ok` to `inaccurate` if the error of an elasticity exceeds the accuracy.
void require_accurate(double accuracy, MomentSensitivities& s) {
  double largest = 0;
  for (const ExpectationDerivatives& one : s.expectations) {
    for (std::size_t k = 0; k < s.parameters.size(); ++k) {
      if (std::isnan(elasticity(s, one, k))) continue;
      const double error = elasticity_error_estimate(s, one, k);
      if (!std::isnan(largest) && !(error <= largest)) largest = error;
    }
  }
  if (s.status != transform::Status::ok || largest <= accuracy) return;
  s.status = transform::Status::inaccurate;
  s.reason = std::isnan(largest)
                 ? "the derivatives have no error estimate"
                 : fmt::format("an elasticity has the estimated error {:.1e} (--accuracy {:g})",
                               largest, accuracy);
}

}  // namespace

const base::OptionsDescription<SensitivityOptions>& sensitivity_option_descriptions() {
  static const auto description = with_functional_options(
      base::OptionsDescription<SensitivityOptions>("sensitivity ")
          .add("parameters", &SensitivityOptions::parameters,
               {"LIST",
                "keys of parameters, such as system.damping,impulse.rate (default: all numbers of "
                "the case)"}),
      "largest error of an elasticity by finite volumes or a closure, and largest L1 error of "
      "theta dp/dtheta by finite volumes, for status ok",
      "simulated time of each changed problem (default: a sixteenth of that of `fpkcheck mcs`, at "
      "most about 10 s of computing for all problems)",
      "ids of methods: fd-kf, fd-white, .., epc-polar-n6, epc-moment-n8, .., mcs");
  return description;
}

SensitivityStudy study_sensitivity(const problem::Problem& problem,
                                   const SensitivityOptions& options,
                                   const methods::ProgressListener& listener) {
  const auto keys = selected_parameters(problem, options);
  SensitivityStudy study{problem, options, {}};
  const auto axes = compare::undivided_comparison_bins(compare::comparison_bins(problem));
  for_each_selected_method(
      problem, options, listener,
      [&](const SelectedFunctionalMethod& method) {
        std::vector<problem::ParameterDifferenceQuotient> parameters;
        for (const std::string& key : keys) {
          parameters.push_back(problem::parameter_difference_quotient(problem, key,
                                                                      method.fd ? kMatrixStep
                                                                      : method.epc
                                                                          ? kClosureStep
                                                                          : kSimulationStep));
        }
        study.solutions.push_back(
            method.fd ? fd_fpk::solve_sensitivities(problem, *method.fd, parameters, axes.y_edges,
                                                    axes.v_edges)
            : method.epc ? epc::solve_sensitivities(problem, *method.epc, parameters)
                         : mcs::estimate_sensitivities(problem, *method.mcs, parameters));
        if (method.epc) require_accurate(options.accuracy, study.solutions.back());
      },
      SelectableFunctionalMethods::with_closures);
  return study;
}

bool has_converged(const SensitivityStudy& study) {
  return have_converged_results(without_closures(study.solutions));
}

std::string study_json_text(const SensitivityStudy& study, const std::string& command) {
  using results::Json;
  Json list = Json::array();
  for (const MomentSensitivities& s : study.solutions) {
    const Json of_solution{{"solution", s.id},
                           {"status", name(s.status)},
                           {"reason", s.reason},
                           {"seconds", s.seconds}};
    if (!has_derivatives(s)) list.push_back(of_solution);
    for (const ExpectationDerivatives& one : s.expectations) {
      Json entry = of_solution;
      entry["of"] = one.expectation;
      entry["value"] = one.value;
      for (std::size_t k = 0; k < s.parameters.size(); ++k) {
        entry["derivatives"][s.parameters[k]] = one.derivatives[k];
        entry["elasticities"][s.parameters[k]] = elasticity(s, one, k);
        entry["error"][s.parameters[k]] = one.errors[k];
      }
      entry["error_is"] = error_kind_text(s.has_standard_errors);
      list.push_back(std::move(entry));
    }
    for (const MarginalDerivatives& marginal : s.marginals) {
      Json entry = of_solution;
      entry["of"] = density_symbol(marginal.variable);
      for (std::size_t k = 0; k < s.parameters.size(); ++k) {
        entry["l1_norm"][s.parameters[k]] = marginal.l1_norm(marginal.derivatives[k]);
        entry["error"][s.parameters[k]] = marginal.l1_norm(marginal.errors[k]);
      }
      entry["error_is"] = error_kind_text(s.has_standard_errors);
      list.push_back(std::move(entry));
    }
  }
  return functional_json(study.problem, "sensitivities", list, command);
}

std::string study_csv_text(const SensitivityStudy& study) {
  std::vector<StudyRecord> rows;
  for (const MomentSensitivities& s : study.solutions) {
    for (const ExpectationDerivatives& one : s.expectations) {
      for (std::size_t k = 0; k < s.parameters.size(); ++k) {
        rows.push_back({{"case", study.problem.name},
                        {"solution", s.id},
                        {"of", one.expectation},
                        {"parameter", s.parameters[k]},
                        {"derivative", one.derivatives[k]},
                        {"elasticity", elasticity(s, one, k)},
                        {"error", one.errors[k]}});
      }
    }
    for (const MarginalDerivatives& marginal : s.marginals) {
      for (std::size_t k = 0; k < s.parameters.size(); ++k) {
        for (std::size_t b = 0; b < marginal.derivatives[k].size(); ++b) {
          rows.push_back({{"case", study.problem.name},
                          {"solution", s.id},
                          {"of", density_symbol(marginal.variable)},
                          {"parameter", s.parameters[k]},
                          {"derivative", marginal.derivatives[k][b]},
                          {"error", marginal.errors[k][b]},
                          {"abscissa", marginal.bin_centre(b)}});
        }
      }
    }
  }
  return records_csv_text(rows, "case solution of parameter derivative elasticity error abscissa");
}

std::string study_table_text(const SensitivityStudy& study,
                             const report::TerminalTextFormat& format) {
  std::string text = report::wrap_text(report::case_title(study.problem), format.width);
  text += report::wrap_text(
      "derivative of each moment with respect to each parameter, all other parameters fixed, and "
      "elasticity: relative change of the moment by a relative change of the parameter",
      format.width);
  const MomentSensitivities* first = nullptr;
  std::vector<StudyTableColumn> columns{
      {"", "moment", "of", "", report::kAlwaysShown, true},
      {"", "parameter", "parameter", "", report::kAlwaysShown, true}};
  std::vector<StudyRecord> rows;
  for (const MomentSensitivities& s : study.solutions) {
    if (!has_derivatives(s)) continue;
    if (first == nullptr) {
      first = &s;
      columns.push_back({"", "elasticity", "elasticity", "{:.4f}"});
    }
    append_value_columns(s.id, "derivative", s.has_standard_errors, columns);
    std::size_t row = 0;
    for (const ExpectationDerivatives& one : s.expectations) {
      for (std::size_t k = 0; k < s.parameters.size(); ++k, ++row) {
        if (row == rows.size()) {
          // The table shows an empty text as a missing value, but shows a blank as a blank.
          rows.push_back({{"of", k == 0 ? one.expectation : std::string(" ")},
                          {"parameter", s.parameters[k]},
                          {"elasticity", elasticity(s, one, k)}});
        }
        rows[row].push_back({s.id, one.derivatives[k]});
        rows[row].push_back({s.id + "-error", one.errors[k]});
      }
    }
  }
  if (first != nullptr) text += records_table_text(rows, columns, format);
  for (const MomentSensitivities& s : study.solutions) {
    std::string line = solution_status_line(s.id, s.status, s.reason);
    if (has_derivatives(s)) line += fmt::format("{} ({:.1f} s)", s.details, s.seconds);
    text += report::wrap_text(line, format.width, 2);
  }
  return text;
}

namespace {

// Returns the panels of theta dp/dtheta over y and over y', with a series for each parameter theta.
std::vector<report::FigurePanel> density_panels(const MomentSensitivities& s) {
  // Palette of Okabe and Ito, which colour-blind readers can distinguish
  constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                      "#E69F00", "#000000", "#882E72"};
  std::vector<report::FigurePanel> panels;
  for (const MarginalDerivatives& marginal : s.marginals) {
    const bool is_y = marginal.variable == transform::StateVariable::y;
    std::vector<report::FigureSeries> series;
    for (std::size_t k = 0; k < s.parameters.size(); ++k) {
      report::FigureSeries curve{.name = s.parameters[k],
                                 .colour = kColours[k % std::size(kColours)],
                                 .dash = k < std::size(kColours) ? "solid" : "(8,4)"};
      for (std::size_t b = 0; b < marginal.derivatives[k].size(); ++b) {
        curve.points.push_back(
            {.x = marginal.bin_centre(b), .y = s.parameter_values[k] * marginal.derivatives[k][b]});
      }
      series.push_back(std::move(curve));
    }
    panels.push_back(
        {.title = fmt::format("derivatives of {} for relative changes of parameters, {}",
                              report::density_in_enhanced_text(marginal.variable),
                              report::escape_enhanced_text(s.id)),
         .x = {is_y ? "{/:Italic y}" : "{/:Italic y}'", marginal.edges.front(),
               marginal.edges.back()},
         .y = report::linear_axis("{/Symbol q} d{/:Italic p}/d{/Symbol q}", series,
                                  &report::FigurePoint::y),
         .series = series});
  }
  return panels;
}

}  // namespace

report::Figure study_figure(const SensitivityStudy& study) {
  report::Figure figure{.title = report::problem_title_parts(study.problem), .columns = 1};
  const auto with_values = std::ranges::find_if(study.solutions, has_derivatives);
  if (with_values == study.solutions.end()) return {};
  const MomentSensitivities& reference = *with_values;
  for (const std::string& wanted : {std::string("E[y^2]"), std::string("E[y'^2]")}) {
    std::vector<report::FigureSeries> series;
    const auto methods =
        methods_selected_by_list(study.options, SelectableFunctionalMethods::with_closures);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const SelectedFunctionalMethod& method = methods[m];
      const auto found =
          std::ranges::find(study.solutions, method.identity.id, &MomentSensitivities::id);
      if (found == study.solutions.end() || !has_derivatives(*found)) continue;
      const auto one =
          std::ranges::find(found->expectations, wanted, &ExpectationDerivatives::expectation);
      report::FigureSeries points =
          report::make_empty_figure_series(found->id, method.identity.plot_style);
      points.dash = "";
      // The marks of a parameter are drawn side by side.
      const double shift =
          0.15 * (static_cast<double>(m) - (static_cast<double>(methods.size()) - 1) / 2);
      for (std::size_t k = 0; k < found->parameters.size(); ++k) {
        const double value = elasticity(*found, *one, k);
        const double half =
            (found->has_standard_errors ? 2 : 1) * elasticity_error_estimate(*found, *one, k);
        points.points.push_back({.x = static_cast<double>(k + 1) + shift,
                                 .y = value,
                                 .lower = value - half,
                                 .upper = value + half});
      }
      series.push_back(std::move(points));
    }
    report::FigureAxis parameters{
        .label = "", .from = 0.5, .to = static_cast<double>(reference.parameters.size()) + 0.5};
    for (std::size_t k = 0; k < reference.parameters.size(); ++k) {
      parameters.tics.push_back({reference.parameters[k], static_cast<double>(k + 1)});
    }
    figure.panels.push_back(
        {.title = fmt::format("elasticities of {}", wanted == "E[y^2]" ? "E[y²]" : "E[y'²]"),
         .x = parameters,
         .y = report::linear_axis("elasticity", series, &report::FigurePoint::y),
         .series = series});
  }
  const auto with_densities = std::ranges::find_if(
      study.solutions, [](const MomentSensitivities& s) { return !s.marginals.empty(); });
  if (with_densities != study.solutions.end()) {
    std::ranges::move(density_panels(*with_densities), std::back_inserter(figure.panels));
  }
  return figure;
}

}  // namespace fpkcheck::study
