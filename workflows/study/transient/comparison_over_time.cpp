#include "workflows/study/transient/comparison_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/comparison_bins.hpp"
#include "epc/transient.hpp"
#include "fd_fpk/transient_with_error.hpp"
#include "mcs/transient.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"
#include "results/netcdf/writer.hpp"
#include "results/run.hpp"
#include "workflows/study/transient/report_over_time.hpp"

namespace fpkcheck::study {
namespace {

using results::Json;
using transform::Marginal;
using transform::Moments;
using transform::StateVariable;
using transform::Status;
using transform::TransientDensities;
using transform::TransientDensitySnapshot;

constexpr int kMostIntervals = 1000;

}  // namespace

const Marginal& marginal_of_variable(const TransientDensitySnapshot& snapshot,
                                     StateVariable variable) {
  return variable == StateVariable::y ? snapshot.y : snapshot.ydot;
}

std::optional<MarginalL1Distances> l1_distances_at(const TransientDensities& solution,
                                                   const TransientDensities& reference,
                                                   std::size_t snapshot) {
  if (&solution == &reference || snapshot >= solution.snapshots.size() ||
      snapshot >= reference.snapshots.size()) {
    return std::nullopt;
  }
  const TransientDensitySnapshot &a = solution.snapshots[snapshot],
                                 &b = reference.snapshots[snapshot];
  return MarginalL1Distances{l1_distance(a.y, b.y), l1_distance(a.ydot, b.ydot)};
}

std::vector<std::size_t> evenly_spaced_snapshots(const TransientComparison& study,
                                                 int most_intervals) {
  const int last = study.options.snapshots, step = (last + most_intervals - 1) / most_intervals;
  std::vector<std::size_t> indices;
  for (int k = 0; k < last; k += step) indices.push_back(static_cast<std::size_t>(k));
  indices.push_back(static_cast<std::size_t>(last));
  return indices;
}

namespace {

std::optional<double> moment_error_estimate(const TransientDensitySnapshot& snapshot,
                                            double Moments::*moment) {
  return snapshot.error ? std::optional(snapshot.error->moments.*moment) : std::nullopt;
}

/// Largest L1 distance of a solution to the reference over time, and the largest difference of the
/// second moments.
struct LargestDistancesFromReference {
  double y = 0, y_time = 0;
  double ydot = 0, ydot_time = 0;
  /// Largest difference of a second moment from the reference, in units of the combined errors of
  /// the two solutions.
  double moment_in_errors = 0;
  /// Earliest time after which the L1 distances of p(y) and p(y') are at most the requested
  /// accuracy; empty if no such time exists.
  std::optional<double> accurate_from;
};

LargestDistancesFromReference largest_distances(const TransientDensities& solution,
                                                const TransientDensities& reference,
                                                double accuracy) {
  LargestDistancesFromReference largest;
  for (std::size_t k = 0; k < solution.snapshots.size(); ++k) {
    const auto at = l1_distances_at(solution, reference, k);
    if (!at) break;
    const TransientDensitySnapshot &a = solution.snapshots[k], &b = reference.snapshots[k];
    if (at->y > largest.y) {
      largest.y = at->y;
      largest.y_time = a.time;
    }
    if (at->ydot > largest.ydot) {
      largest.ydot = at->ydot;
      largest.ydot_time = a.time;
    }
    if (std::max(at->y, at->ydot) > accuracy) {
      largest.accurate_from.reset();
    } else if (!largest.accurate_from) {
      largest.accurate_from = a.time;
    }
    for (double Moments::*moment : {&Moments::y2, &Moments::v2}) {
      const auto of_a = moment_error_estimate(a, moment), of_b = moment_error_estimate(b, moment);
      const double combined = std::hypot(of_a.value_or(0), of_b.value_or(0));
      if (!of_a || !of_b || combined == 0) continue;
      // The error estimates of finite volumes at time 0 do not contain the rounding errors of the
      // initial density.
      if (a.time == 0 && !solution.has_standard_errors) continue;
      largest.moment_in_errors = std::max(
          largest.moment_in_errors, std::abs(a.moments.*moment - b.moments.*moment) / combined);
    }
  }
  return largest;
}

// Returns the largest L1 error estimate over all snapshots; NaN if a snapshot has no error
// estimate.
double largest_l1_error_estimate(const TransientDensities& solution) {
  double largest = 0;
  for (const TransientDensitySnapshot& s : solution.snapshots) {
    if (!s.error) return std::numeric_limits<double>::quiet_NaN();
    for (const double error : {s.error->y_l1, s.error->ydot_l1}) {
      if (std::isnan(error)) return error;
      largest = std::max(largest, error);
    }
  }
  return largest;
}

// Returns the largest difference between 1 and the integral of a marginal density over its bins.
double largest_missing_mass(const TransientDensities& solution) {
  double largest = 0;
  for (const TransientDensitySnapshot& s : solution.snapshots) {
    for (const Marginal* p : {&s.y, &s.ydot}) {
      double mass = 0;
      for (std::size_t b = 0; b < p->size(); ++b) mass += p->density[b] * p->bin_width(b);
      const double missing = std::abs(1 - mass);
      if (!(missing <= largest)) largest = missing;
    }
  }
  return largest;
}

}  // namespace

void require_accurate(double accuracy, const TransientDensities* compared_with,
                      TransientDensities& solution) {
  if (solution.status != Status::ok) return;
  constexpr double kMassLimit = 1e-3;
  const double missing = largest_missing_mass(solution);
  const bool has_moments =
      std::ranges::all_of(solution.snapshots, [](const TransientDensitySnapshot& s) {
        return std::isfinite(s.moments.y2) && std::isfinite(s.moments.v2);
      });
  const auto refuse = [&](std::string reason) {
    solution.status = Status::inaccurate;
    solution.reason = std::move(reason);
  };
  if (!has_moments) return refuse("a moment is not finite");
  if (!(missing < kMassLimit)) {
    return refuse(fmt::format("the mass in the bins differs from 1 by {:.1e} (limit {:.0e})",
                              missing, kMassLimit));
  }
  if (solution.has_standard_errors) return;
  const double estimate = largest_l1_error_estimate(solution);
  double error = estimate;
  if (compared_with && compared_with != &solution) {
    const LargestDistancesFromReference largest =
        largest_distances(solution, *compared_with, accuracy);
    const double distance = std::max(largest.y, largest.ydot);
    const double of_reference = largest_l1_error_estimate(*compared_with);
    if (distance - of_reference > accuracy) {
      return refuse(fmt::format("the L1 distance to {} is {:.1e} (--accuracy {:g})",
                                compared_with->id, distance, accuracy));
    }
    error = std::fmin(estimate, distance + of_reference);  // fmin() ignores NaN
  }
  if (error <= accuracy) return;
  refuse(std::isnan(error)
             ? "the density has no error estimate at some times"
             : fmt::format("the estimated L1 error is {:.1e} (--accuracy {:g})", error, accuracy));
}

namespace {

// Extends a list of evenly spaced bin edges with the same spacing, so that the bins cover [low,
// high].
std::vector<double> extended_edges(std::vector<double> edges, double low, double high) {
  constexpr std::size_t kMostBins = 2000;
  const double width = edges[1] - edges[0];
  std::vector<double> lower;
  for (double edge = edges.front(); edge > low && lower.size() < kMostBins;) {
    lower.push_back(edge -= width);
  }
  edges.insert(edges.begin(), lower.rbegin(), lower.rend());
  while (edges.back() < high && edges.size() < 2 * kMostBins) {
    edges.push_back(edges.back() + width);
  }
  return edges;
}

// Sets histogram bins that cover the stationary density and all states that the initial density
// reaches, extended by the motion under the force F(t).
void set_histogram_bins(const problem::Problem& given, transform::TransientRequest& request) {
  const problem::Problem problem = problem::with_largest_excitation(given, request.time_span());
  const auto axes = compare::undivided_comparison_bins(compare::comparison_bins(problem));
  const problem::Problem transformed =
      problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
  const problem::StateRange reached = problem::reachable_state_range(
      transformed,
      problem::initial_density(transformed, problem::motion_scales(transformed), request.start));
  const auto [low, high] = std::minmax(
      {transformed.frame.physical_y(reached.y_low), transformed.frame.physical_y(reached.y_high)});
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  const problem::MotionExtent forced = problem::forced_motion_extent(problem, request.time_span());
  const auto &y = axes.y_edges, &v = axes.v_edges;
  request.y_edges =
      extended_edges(y, left ? y.front() : std::min(low, y.front()) - forced.displacement,
                     right ? y.back() : std::max(high, y.back()) + forced.displacement);
  const double v_high = std::max(reached.v_high, v.back()) + forced.speed;
  request.v_edges = extended_edges(v, -v_high, v_high);
}

}  // namespace

const base::OptionsDescription<TransientComparisonOptions>&
transient_comparison_option_descriptions() {
  using namespace base;
  using T = TransientComparisonOptions;
  static const auto description = with_functional_options(
      OptionsDescription<T>("run ")
          .add("until", &T::until, {"T", "end time of the densities"}, positive_numbers())
          .add("snapshots", &T::snapshots, {"N", "number of intervals between stored densities"},
               closed_interval(1, kMostIntervals))
          .with_default(T().snapshots)
          .add("periodic", &T::periodic,
               {"", "densities of the periodic state; T is the period of the excitation"})
          .add("start_y", &T::start_y,
               {"S",
                "standard deviation of y at t = 0 (default: about half of the stationary "
                "deviation)"},
               positive_numbers())
          .add("start_v", &T::start_v,
               {"S",
                "standard deviation of y' at t = 0 (default: about half of the stationary "
                "deviation)"},
               positive_numbers())
          .add("start_mean_y", &T::start_mean_y,
               {"M",
                "mean of y at t = 0, before truncation at the walls (default: about E[y]; the "
                "position of the wall, if there is only one wall, at the equilibrium)"},
               finite_numbers())
          .add("start_mean_v", &T::start_mean_v, {"M", "mean of y' at t = 0 (default: 0)"},
               finite_numbers()),
      "largest estimated L1 error of p(y) and p(y') for status ok",
      "simulated time of all paths (default: 1e6 paths, or some seconds)",
      "ids of methods: fd-kf, fd-white, .., epc-polar-n6, epc-moment-n8, .., mcs");
  return description;
}

TransientComparison compare_over_time(const problem::Problem& problem,
                                      const TransientComparisonOptions& options,
                                      const methods::ProgressListener& listener) {
  transform::TransientRequest request{.start = {.displacement_deviation = options.start_y,
                                                .velocity_deviation = options.start_v,
                                                .mean_displacement = options.start_mean_y,
                                                .mean_velocity = options.start_mean_v},
                                      .until = options.until,
                                      .periodic = options.periodic,
                                      .snapshots = options.snapshots};
  set_histogram_bins(problem, request);
  TransientComparison study{problem, options, {}};
  for_each_selected_method(
      problem, options, listener,
      [&](const SelectedFunctionalMethod& method) {
        TransientDensities solution =
            method.fd    ? fd_fpk::solve_transient_with_error(problem, *method.fd, request)
            : method.epc ? epc::solve_transient(problem, *method.epc, request)
                         : mcs::estimate_transient(problem, *method.mcs, request);
        study.solutions.push_back(std::move(solution));
      },
      SelectableFunctionalMethods::with_closures);
  const TransientDensities* const compared_with = find_reference_solution(study);
  const auto selected =
      methods_selected_by_list(options, SelectableFunctionalMethods::with_closures);
  const auto equation = [&](const TransientDensities& solution) {
    return find_method(selected, solution.id)->identity.equation;
  };
  for (TransientDensities& solution : study.solutions) {
    const bool is_same_problem =
        compared_with != nullptr && equation(*compared_with) == equation(solution);
    require_accurate(options.accuracy, is_same_problem ? compared_with : nullptr, solution);
  }
  return study;
}

namespace {

bool has_all_snapshots(const TransientComparison& study, const TransientDensities& solution) {
  return (solution.status == Status::ok || solution.status == Status::inaccurate) &&
         static_cast<int>(solution.snapshots.size()) == study.options.snapshots + 1;
}

// Returns the means of the moments over a period of the excitation, by the trapezoidal rule. The
// result is empty if the number of snapshots in a period is too small for the harmonics of the
// moments.
std::optional<Moments> mean_over_period(const TransientComparison& study,
                                        const TransientDensities& solution) {
  constexpr int kFewestPhases = 8;
  if (!study.options.periodic || study.options.snapshots < kFewestPhases ||
      !has_all_snapshots(study, solution)) {
    return std::nullopt;
  }
  Moments mean{};
  const std::size_t intervals = solution.snapshots.size() - 1;
  for (std::size_t k = 0; k < intervals; ++k) {
    for (double Moments::*moment :
         {&Moments::y1, &Moments::y2, &Moments::y4, &Moments::v1, &Moments::v2, &Moments::v4}) {
      mean.*moment += solution.snapshots[k].moments.*moment / static_cast<double>(intervals);
    }
  }
  return mean;
}

}  // namespace

const TransientDensities* find_reference_solution(const TransientComparison& study) {
  for (const char* solver : {"fd", "mcs"}) {
    for (const TransientDensities& solution : study.solutions) {
      if (solution.id.starts_with(solver) && has_all_snapshots(study, solution)) return &solution;
    }
  }
  return nullptr;
}

bool has_converged(const TransientComparison& study) {
  return have_converged_results(without_closures(study.solutions));
}

std::string study_json_text(const TransientComparison& study, const std::string& command) {
  const TransientDensities* const compared_with = find_reference_solution(study);
  Json list = Json::array();
  for (const TransientDensities& solution : study.solutions) {
    Json times = Json::array(), moments = Json::array(), errors = Json::array();
    Json l1 = Json::array(), l1_errors = Json::array();
    for (std::size_t k = 0; k < solution.snapshots.size(); ++k) {
      const TransientDensitySnapshot& s = solution.snapshots[k];
      times.push_back(s.time);
      moments.push_back(results::moments_to_json(s.moments));
      errors.push_back(s.error ? results::moments_to_json(s.error->moments) : Json());
      l1_errors.push_back(s.error ? Json{{"y", s.error->y_l1}, {"ydot", s.error->ydot_l1}}
                                  : Json());
      const auto at = compared_with ? l1_distances_at(solution, *compared_with, k) : std::nullopt;
      l1.push_back(at ? Json{{"y", at->y}, {"ydot", at->ydot}} : Json());
    }
    const auto mean = mean_over_period(study, solution);
    list.push_back({{"solution", solution.id},
                    {"status", name(solution.status)},
                    {"reason", solution.reason},
                    {"seconds", solution.seconds},
                    {"times", times},
                    {"moments", moments},
                    {solution.has_standard_errors ? "standard_errors" : "error", errors},
                    {"l1", l1},
                    {"l1_error", l1_errors},
                    {"mean_over_period", mean ? results::moments_to_json(*mean) : Json()},
                    {"reference", compared_with ? Json(compared_with->id) : Json()}});
  }
  return functional_json(study.problem, "over_time", list, command);
}

std::string study_csv_text(const TransientComparison& study) {
  std::vector<StudyRecord> rows;
  for (const TransientDensities& solution : study.solutions) {
    for (const TransientDensitySnapshot& s : solution.snapshots) {
      for (const StateVariable variable : transform::kVariables) {
        const Marginal& p = marginal_of_variable(s, variable);
        for (std::size_t b = 0; b < p.size(); ++b) {
          StudyRecord row{{"case", study.problem.name},
                          {"solution", solution.id},
                          {"time", s.time},
                          {"variable", std::string(name(variable))},
                          {"abscissa", p.bin_centre(b)},
                          {"density", p.density[b]}};
          if (!p.lower.empty()) {
            row.push_back({"lower", p.lower[b]});
            row.push_back({"upper", p.upper[b]});
          }
          rows.push_back(std::move(row));
        }
      }
    }
  }
  return records_csv_text(rows, "case solution time variable abscissa density lower upper");
}

namespace {

using ValuePair = std::array<double, 2>;

/// Returns a table with two columns for each solution, and a row for each shown snapshot. The table
/// text is empty if no solution has values.
/// @param values function that returns the two values of a solution at a snapshot, or an empty
///        value
std::string table_over_time(
    const TransientComparison& study, const std::array<const char*, 2>& headers,
    const std::function<std::optional<ValuePair>(const TransientDensities&, std::size_t snapshot)>&
        values,
    const report::TerminalTextFormat& format) {
  const transform::TransientRequest request{.until = study.options.until,
                                            .snapshots = study.options.snapshots};
  constexpr int kMostIntervalsInTable = 10;
  const std::vector<std::size_t> shown = evenly_spaced_snapshots(study, kMostIntervalsInTable);
  std::vector<StudyRecord> rows;
  for (const std::size_t k : shown) {
    rows.push_back({{"time", request.time_of_snapshot(static_cast<int>(k))}});
  }
  std::vector<StudyTableColumn> columns{{"", "t", "time", "{:.4g}"}};
  for (const TransientDensities& solution : study.solutions) {
    if (!values(solution, 0)) continue;
    for (std::size_t part = 0; part < 2; ++part) {
      const std::string path = solution.id + headers[part];
      columns.push_back({solution.id, headers[part], path, "{:.5f}"});
      for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto pair = values(solution, shown[row]);
        if (pair) rows[row].push_back({path, (*pair)[part]});
      }
    }
  }
  return columns.size() == 1 ? "" : records_table_text(rows, columns, format);
}

std::string moment_table(const TransientComparison& study,
                         const report::TerminalTextFormat& format) {
  const auto values = [](const TransientDensities& solution,
                         std::size_t k) -> std::optional<ValuePair> {
    if (k >= solution.snapshots.size()) return std::nullopt;
    const Moments& moments = solution.snapshots[k].moments;
    return ValuePair{moments.y2, moments.v2};
  };
  return table_over_time(study, {"E[y^2]", "E[y'^2]"}, values, format);
}

std::string distance_table(const TransientComparison& study,
                           const TransientDensities& compared_with,
                           const report::TerminalTextFormat& format) {
  const auto values = [&](const TransientDensities& solution,
                          std::size_t k) -> std::optional<ValuePair> {
    const auto at = l1_distances_at(solution, compared_with, k);
    return at ? std::optional(ValuePair{at->y, at->ydot}) : std::nullopt;
  };
  return table_over_time(study, {"p(y)", "p(y')"}, values, format);
}

}  // namespace

std::string solution_summary_text(const TransientComparison& study,
                                  const TransientDensities& solution,
                                  const TransientDensities* compared_with) {
  std::string line = solution_status_line(solution.id, solution.status, solution.reason);
  if (solution.snapshots.empty()) return line.substr(0, line.rfind(';'));
  const double estimate = largest_l1_error_estimate(solution);
  const bool has_evolved = solution.snapshots.back().time > 0;
  if (std::isfinite(estimate) && has_evolved) {
    line += fmt::format("{} at most {:.1e} in L1",
                        solution.has_standard_errors     ? "expected sampling error"
                        : solution.id.starts_with("epc") ? "difference from order n-2"
                                                         : "estimated error",
                        estimate);
  } else {
    line += "no error estimate";
  }
  if (compared_with && compared_with != &solution) {
    const LargestDistancesFromReference largest =
        largest_distances(solution, *compared_with, study.options.accuracy);
    line += fmt::format(
        "; distance to {} at most {:.1e} in p(y) (t = {:.4g}), {:.1e} in p(y') (t "
        "= {:.4g}); second moments differ by at most {:.1f} combined errors",
        compared_with->id, largest.y, largest.y_time, largest.ydot, largest.ydot_time,
        largest.moment_in_errors);
    if (!solution.has_standard_errors) {
      const double end = solution.snapshots.back().time;
      const std::string range =
          end < study.options.until ? fmt::format("to the last time t = {:.4g}", end) : "on";
      line += largest.accurate_from
                  ? fmt::format("; within {:g} from t = {:.4g} {}", study.options.accuracy,
                                *largest.accurate_from, range)
                  : fmt::format("; not within {:g} at the end", study.options.accuracy);
    }
  }
  if (const auto mean = mean_over_period(study, solution)) {
    line += fmt::format("; mean over the period: E[y] = {:.5f}, E[y^2] = {:.5f}, E[y'^2] = {:.5f}",
                        mean->y1, mean->y2, mean->v2);
  }
  return line + fmt::format("; {} ({:.1f} s)", solution.details, solution.seconds);
}

std::string study_table_text(const TransientComparison& study,
                             const report::TerminalTextFormat& format) {
  const TransientDensities* const compared_with = find_reference_solution(study);
  std::string text = report::wrap_text(report::case_title(study.problem), format.width);
  text += report::wrap_text(
      study.options.periodic ? fmt::format("second moments of the periodic state of period {:.6g}",
                                           study.options.until)
                             : "second moments over time, from a Gaussian density at t = 0",
      format.width);
  text += moment_table(study, format);
  if (compared_with) {
    const std::string distances_text = distance_table(study, *compared_with, format);
    if (!distances_text.empty()) {
      text += report::wrap_text(fmt::format("L1 distance to {}", compared_with->id), format.width) +
              distances_text;
    }
  }
  for (const TransientDensities& solution : study.solutions) {
    text +=
        report::wrap_text(solution_summary_text(study, solution, compared_with), format.width, 2);
  }
  return text;
}

namespace {

using Methods = std::vector<SelectedFunctionalMethod>;

// Returns a plot series without points, in the plot style of the method. The marks of different
// solutions are at different times, so that marks do not overlap.
report::FigureSeries make_empty_figure_series(const Methods& methods,
                                              const TransientDensities& solution) {
  const auto method = find_method(methods, solution.id);
  report::FigureSeries series =
      report::make_empty_figure_series(solution.id, method->identity.plot_style);
  series.group = solution.id;
  series.mark_step = methods.size();
  series.first_mark = static_cast<std::size_t>(method - methods.begin());
  if (solution.has_standard_errors) series.dash = "";
  return series;
}

report::FigurePanel moment_panel(const TransientComparison& study, const Methods& methods,
                                 const std::string& title, const std::string& label,
                                 double Moments::*moment) {
  std::vector<report::FigureSeries> all;
  for (const TransientDensities& solution : study.solutions) {
    if (solution.snapshots.empty()) continue;
    report::FigureSeries series = make_empty_figure_series(methods, solution);
    for (const TransientDensitySnapshot& s : solution.snapshots) {
      const double error = solution.has_standard_errors ? s.error->moments.*moment : 0;
      series.points.push_back(figure_point_with_error_interval(s.time, s.moments.*moment, error,
                                                               solution.has_standard_errors));
    }
    all.push_back(std::move(series));
  }
  return {.title = title,
          .x = {"{/:Italic t}", 0, study.options.until},
          .y = report::linear_axis(label, all, &report::FigurePoint::y),
          .series = all};
}

report::FigurePanel distance_panel(const TransientComparison& study, const Methods& methods,
                                   const TransientDensities& compared_with,
                                   const std::string& title,
                                   double MarginalL1Distances::*distance) {
  std::vector<report::FigureSeries> all;
  for (const TransientDensities& solution : study.solutions) {
    report::FigureSeries series = make_empty_figure_series(methods, solution);
    for (std::size_t k = 0; k < solution.snapshots.size(); ++k) {
      if (const auto at = l1_distances_at(solution, compared_with, k)) {
        series.points.push_back({.x = solution.snapshots[k].time, .y = (*at).*distance});
      }
    }
    if (!series.points.empty()) all.push_back(std::move(series));
  }
  return {.title = title,
          .x = {"{/:Italic t}", 0, study.options.until},
          .y = report::logarithmic_axis("{/:Italic L}_1", all, &report::FigurePoint::y),
          .series = all};
}

}  // namespace

report::Figure study_figure(const TransientComparison& study) {
  const TransientDensities* const compared_with = find_reference_solution(study);
  if (compared_with == nullptr) return {};
  const Methods methods =
      methods_selected_by_list(study.options, SelectableFunctionalMethods::with_closures);
  std::vector<report::FigurePanel> panels{
      moment_panel(study, methods, "mean square displacement", "E[{/:Italic y}^2]", &Moments::y2),
      moment_panel(study, methods, "mean square velocity", "E[{/:Italic y}'^2]", &Moments::v2)};
  if (study.solutions.size() > 1) {
    panels.push_back(distance_panel(study, methods, *compared_with,
                                    fmt::format("distance of p(y) to {}", compared_with->id),
                                    &MarginalL1Distances::y));
    panels.push_back(distance_panel(study, methods, *compared_with,
                                    fmt::format("distance of p(y') to {}", compared_with->id),
                                    &MarginalL1Distances::ydot));
  }
  for (const StateVariable variable : transform::kVariables) {
    MarginalDensityOverTime density{
        .edges = marginal_of_variable(compared_with->snapshots.front(), variable).edges};
    for (const TransientDensitySnapshot& s : compared_with->snapshots) {
      density.times.push_back(s.time);
      density.averages.push_back(&marginal_of_variable(s, variable).density);
    }
    panels.push_back(density_heat_map_panel(
        density,
        fmt::format("{} by {}", variable == StateVariable::y ? "displacement" : "velocity",
                    compared_with->id),
        variable == StateVariable::y ? "{/:Italic y}" : "{/:Italic y}'"));
  }
  return {.title = report::problem_title_parts(study.problem), .panels = panels, .columns = 2};
}

std::string study_netcdf_bytes(const TransientComparison& study, const std::string& command) {
  const TransientDensities* const compared_with = find_reference_solution(study);
  if (compared_with == nullptr) return "";
  results::NetCdfWriter file;
  file.write_attribute("Conventions", "CF-1.8");
  file.write_attribute("title", "marginal densities over time of a randomly excited oscillator");
  file.write_attribute("command", command);
  results::write_problem_attributes(file, study.problem);
  std::vector<std::string> ids;
  for (const TransientDensities& solution : study.solutions) ids.push_back(solution.id);
  std::vector<double> times;
  for (const TransientDensitySnapshot& s : compared_with->snapshots) times.push_back(s.time);
  const int solution_dimension = file.define_dimension("solution", ids.size());
  file.write_labels("solution", solution_dimension, ids);
  const int time = file.define_dimension("time", times.size());
  const int bounds = file.define_dimension("bounds", 2);
  file.write_variable("time", {time}, "time", times);
  for (const StateVariable variable : transform::kVariables) {
    const std::string id(name(variable));
    const std::string meaning = variable == StateVariable::y ? "displacement y" : "velocity y'";
    const std::vector<double>& edges =
        marginal_of_variable(compared_with->snapshots.front(), variable).edges;
    const int bins = file.write_cell_coordinate(id, meaning, bounds, edges);
    std::vector<double> values;
    for (const TransientDensities& solution : study.solutions) {
      for (std::size_t k = 0; k < times.size(); ++k) {
        if (k < solution.snapshots.size()) {
          const auto& density = marginal_of_variable(solution.snapshots[k], variable).density;
          values.insert(values.end(), density.begin(), density.end());
        } else {
          values.insert(values.end(), edges.size() - 1, std::numeric_limits<double>::quiet_NaN());
        }
      }
    }
    file.write_compressed<double>("p_" + id, {solution_dimension, time, bins},
                                  fmt::format("probability density of the {}", meaning), values);
  }
  return file.close_and_take_bytes();
}

}  // namespace fpkcheck::study
