#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "cli/command_line.hpp"
#include "cli/help.hpp"
#include "cli/program.hpp"
#include "cli/report_of_one_case.hpp"
#include "fd_fpk/options.hpp"
#include "report/text/text_layout.hpp"
#include "workflows/study/closure_order_study.hpp"
#include "workflows/study/grid_convergence_study.hpp"
#include "workflows/study/kramers_moyal_regularisation_study.hpp"

namespace fpkcheck::cli {
namespace {

constexpr const char* kGridUsage = R"(usage: fpkcheck study grid CASE [options]

Grid convergence of the finite volumes for several orders of the scheme: distances of the marginal
densities to their Richardson limit, the observed order over each three grid levels, and limits of
the moments. Also shows error and time of closures and simulation, for the choice of a method.
Exit code 0 when the limit exists and the finest grids give a density.

examples:
  fpkcheck study grid case1
  fpkcheck study grid case4 --orders 5,7 --levels 6 --out results
  fpkcheck study grid case1 --origin-refinement 16                 (resolves the jump at the origin)
  fpkcheck study grid case1 --equation km4 --impact delta          (the equation of the closure)
)";

int study_grid_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  OneCaseReportCommand study_call(call);
  study::GridStudyOptions options;
  const auto& grids = fd_fpk::solver_option_descriptions();
  base::Values grid_values{{"equation", std::string(name(options.equation))},
                           {"impact", std::string(name(options.impact))}};
  std::string order_list;
  po::options_description own;
  own.add(
      make_command_line_options(grids, {"equation", "impact", "origin_refinement"}, grid_values));
  own.add_options()  //
      ("orders", po::value(&order_list)->value_name("LIST")->default_value("3,5,7"),
       "orders of the transport terms, 2 .. 8; the highest order gives the limit")(
          "levels", po::value(&options.levels)->value_name("N")->default_value(options.levels),
          "number of grids for each order; cells are narrower by sqrt(2) from level to level")(
          "coarsest",
          po::value(&options.coarsest)->value_name("F")->default_value(options.coarsest),
          "refinement factor of the first level; 1 is the automatic grid");
  own.add(make_solver_run_options(call.registry, options.simulation));
  own.add(make_figure_options(study_call.common.figures));
  if (!study_call.parse_command_arguments(
          kGridUsage, own, "write study-grid.json, .csv and a figure to DIR (default: no files)"))
    return kSuccess;
  fd_fpk::FiniteVolumeOptions scheme;
  for (const auto& [key, value] : grid_values) {
    grids.assign_option_value(scheme, *grids.find(key), value, "--" + key);
  }
  options.equation = scheme.equation;
  options.impact = scheme.impact;
  options.origin_refinement = scheme.origin_refinement;
  options.orders = parse_integers("--orders", order_list);
  study::validate(options);
  return study_call.compute_and_write_report(
      [&](const problem::Problem& problem, const auto& show) {
        return study::study_grid(problem, options, call.registry, show);
      });
}

constexpr const char* kOrderUsage = R"(usage: fpkcheck study order CASE [options]

Convergence of closures in the order of their polynomial: status, steps of Newton's method,
condition number, residual, admissibility, distance to the finite-volume solution of the full jump
equation (L1, and in the tail), time. Also reports where the branch of solutions of a formulation
folds before it reaches the problem.
Exit code 0 when every order of the formulation moment gives a density.

examples:
  fpkcheck study order case1
  fpkcheck study order case4 --formulations moment --orders 8,12,16 --out results
  fpkcheck study order case1 --formulations gaussian,gaussian-kf,moment,moment-cut
)";

int study_order_command(const CommandInvocation& call) {
  namespace po = boost::program_options;
  OneCaseReportCommand study_call(call);
  std::string formulation_list, order_list;
  const std::string formulations_help = fmt::format(
      "formulations and variants as in ids of solutions, without epc- and -nN: {}; moment-cut is "
      "the unconfined exponent, cut off at an energy",
      fmt::join(study::closure_formulations(call.registry), ", "));
  po::options_description own;
  own.add_options()  //
      ("orders", po::value(&order_list)->value_name("LIST")->default_value("2,4,6,8,10,12"),
       "orders n (degrees of the polynomial), even, from 2")(
          "formulations",
          po::value(&formulation_list)->value_name("LIST")->default_value("gaussian,moment,polar"),
          formulations_help.c_str());
  own.add(make_figure_options(study_call.common.figures));
  if (!study_call.parse_command_arguments(
          kOrderUsage, own, "write study-order.json, .csv and a figure to DIR (default: no files)"))
    return kSuccess;
  const study::ClosureOrderStudyOptions options{
      parse_comma_separated_list("--formulations", formulation_list),
      parse_integers("--orders", order_list)};
  return study_call.compute_and_write_report(
      [&](const problem::Problem& problem, const auto& show) {
        return study::study_closure_orders(problem, options, call.registry, show);
      });
}

constexpr const char* kRegularisationUsage = R"(usage: fpkcheck study regularisation CASE [options]

The series truncated after the fourth derivative, discretised with decreasing velocity steps h:
  literal      fourth difference over the step, l = h: ill-posed, growth rates increase as h falls
  0.9 l*       fixed length below the threshold l* of well-posedness
  1.1 l*       fixed length above the threshold
  regularised  the default length, l^2 = E[Y^6] / (5 E[Y^4])
  pade         the Pade approximant of the series, which has no length
Each row has the largest growth rate of a wave (from the symbol), the rightmost eigenvalue of the
matrix (shift-invert Arnoldi with KLU factors), and the distance of the null vector from the density
of the full jump equation on the same grid.
Exit code 0 when the default length has no growth and gives a density at the smallest step.

examples:
  fpkcheck study regularisation case1
  fpkcheck study regularisation mine.ini --set system.restitution=0.9 --out results
)";

int study_regularisation_command(const CommandInvocation& call) {
  OneCaseReportCommand study_call(call);
  if (!study_call.parse_command_arguments(
          kRegularisationUsage, {},
          "write study-regularisation.json and .csv to DIR (default: no files)"))
    return kSuccess;
  return study_call.compute_and_write_report([](const problem::Problem& problem, const auto& show) {
    return study::study_kramers_moyal_regularisation(problem, show);
  });
}

constexpr const char* kStudyUsage = R"(usage: fpkcheck study SUBJECT CASE [options]

subjects (options: fpkcheck study SUBJECT --help):
)";

std::string study_usage() {
  constexpr std::size_t kWidth = 100, kColumn = 18;
  std::string text = kStudyUsage;
  for (const auto& [name, summary, run] : study_subjects()) {
    auto lines = report::wrap_text(std::string(kColumn, ' ') + summary, kWidth, kColumn);
    text += lines.replace(2, name.size(), name);
  }
  return text;
}

std::string study_subject_list_text() {
  std::string text;
  const auto& all = study_subjects();
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += (k == 0 ? "" : k + 1 < all.size() ? ", " : " or ") + all[k].name;
  }
  return text;
}

}  // namespace

const std::vector<StudySubcommand>& study_subjects() {
  static const std::vector<StudySubcommand> subjects{
      {"grid",
       "grid convergence of the finite volumes: observed orders, limits, and error against cost "
       "for all methods",
       study_grid_command},
      {"order", "convergence of the closures in the order of their polynomial: limit and cost",
       study_order_command},
      {"regularisation",
       "the series truncated after the fourth derivative, over the velocity step: growth rates",
       study_regularisation_command}};
  return subjects;
}

int study_command(const CommandInvocation& call) {
  const auto& arguments = call.arguments;
  const std::string argument = arguments.empty() ? "" : arguments.front();
  if (argument == "--help" || argument == "-h") {
    print_or_capture_help(study_usage(), {});
    return kSuccess;
  }
  if (arguments.empty() || argument.starts_with('-')) {
    throw InputError(
        fmt::format("study without a subject; use study SUBJECT CASE with {} (see --help)",
                    study_subject_list_text()));
  }
  const auto subject = std::ranges::find(study_subjects(), argument, &StudySubcommand::name);
  if (subject == study_subjects().end()) {
    throw InputError(fmt::format("{} is not a subject of study; use {} (see --help)",
                                 base::in_quotes(argument), study_subject_list_text()));
  }
  return subject->run({{arguments.begin() + 1, arguments.end()}, call.command_line, call.registry});
}

}  // namespace fpkcheck::cli
