#include "workflows/study/functionals/functionals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "backward/passage/passage.hpp"
#include "backward/passage/passage_bounds.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "fd_fpk/functionals/energy_passage.hpp"
#include "fd_fpk/functionals/passage.hpp"
#include "mcs/passage.hpp"
#include "problem/effective_potential.hpp"
#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/terminal_tables.hpp"
#include "report/text/text_layout.hpp"

namespace fpkcheck::study {
namespace {

using transform::FirstPassageResult;
using transform::Status;
using transform::ValueWithError;
using Quantity = std::optional<ValueWithError> FirstPassageResult::*;

// Name of the start other than the stationary law, in keys and tables.
struct PassageStartName {
  std::string key, text;
};
PassageStartName start_name(const PassageOptions& options) {
  if (!options.start) return {"rest", "rest"};
  return {"start", "(" + *options.start + ")"};
}

// Returns the barrier of the options, or the two barriers "A,B" of the displacement.
// @throws InputError unless exactly one barrier is given, or two valid barriers
transform::PassageBarrier parse_barrier(const PassageOptions& options) {
  if (options.displacement.has_value() == options.energy.has_value()) {
    throw InputError(options.energy
                         ? "two barriers; give either --displacement or --energy"
                         : "no barrier; give one, e.g. --displacement 1.5 or --energy 1");
  }
  if (options.energy) {
    return {.quantity = transform::PassageBarrier::Quantity::energy, .level = *options.energy};
  }
  const auto refuse = [&](const char* requirement) -> double {
    throw InputError(
        fmt::format("--displacement {} ({})", base::in_quotes(*options.displacement), requirement));
  };
  std::vector<double> levels;
  for (const std::string& item : split_at_commas(*options.displacement)) {
    const auto level = parse_finite_number(item);
    levels.push_back(level ? *level : refuse("must be a barrier B, or two barriers A,B"));
  }
  if (levels.empty() || levels.size() > 2) refuse("must be a barrier B, or two barriers A,B");
  if (levels.size() == 1) return {.level = levels[0]};
  if (!(levels[0] < levels[1])) refuse("the first barrier must be below the second barrier");
  return {.level = levels[1], .lower_level = levels[0]};
}

struct NamedPassageQuantity {
  std::string key;   // key in JSON
  std::string name;  // name in tables
  Quantity quantity;
};
std::vector<NamedPassageQuantity> passage_quantities(const PassageOptions& options) {
  const auto [key, text] = start_name(options);
  const bool two = parse_barrier(options).lower_level.has_value();
  std::vector<NamedPassageQuantity> quantities{
      {"hazard", "hazard", &FirstPassageResult::hazard},
      {"mean_from_" + key, "mean time from " + text, &FirstPassageResult::mean_from_point},
      {"mean_from_stationary", "mean time, stationary start",
       &FirstPassageResult::mean_from_stationary},
      {"rice_rate", two ? "rate of exits (Rice)" : "rate of upcrossings (Rice)",
       &FirstPassageResult::rice_rate},
      {two ? "probability_between" : "probability_below",
       two ? "probability between the barriers" : "probability below the barrier",
       &FirstPassageResult::probability_below}};
  if (two) {
    quantities.push_back({"upper_exit_probability_from_" + key,
                          "probability of exit at the upper barrier, from " + text,
                          &FirstPassageResult::upper_exit_from_point});
    quantities.push_back({"upper_exit_probability_from_stationary",
                          "probability of exit at the upper barrier, stationary start",
                          &FirstPassageResult::upper_exit_from_stationary});
  }
  return quantities;
}

// Returns the text of the quantity that passes the barrier.
std::string barrier_quantity_text(const transform::PassageBarrier& barrier) {
  return barrier.is_energy() ? "the energy" : "y";
}

// Returns the text of the states before the passage: "below 1.5" or "between -1 and 1".
std::string survival_text(const transform::PassageBarrier& barrier) {
  return barrier.lower_level
             ? fmt::format("between {:g} and {:g}", *barrier.lower_level, barrier.level)
             : fmt::format("below {:g}", barrier.level);
}

std::vector<double> parse_survival_times(const PassageOptions& options) {
  std::vector<double> times;
  if (!options.times) return times;
  for (const std::string& item : split_at_commas(*options.times)) {
    const auto number = parse_finite_number(item);
    if (!number || *number < 0) {
      throw InputError(fmt::format("--times {} (must be numbers >= 0, separated by commas)",
                                   base::in_quotes(item)));
    }
    times.push_back(*number);
  }
  return times;
}

// Returns the start Y,V of the options.
// @throws InputError unless the start is below the barrier and between the walls
std::optional<transform::PassageStartState> parse_start(const problem::Problem& problem,
                                                        const PassageOptions& options,
                                                        const transform::PassageBarrier& barrier) {
  if (!options.start) return std::nullopt;
  const auto refuse = [&](const std::string& requirement) {
    throw InputError(fmt::format("--start {} ({})", base::in_quotes(*options.start), requirement));
  };
  const std::vector<std::string> parts = split_at_commas(*options.start);
  std::optional<double> y, ydot;
  if (parts.size() == 2) {
    y = parse_finite_number(parts[0]);
    ydot = parse_finite_number(parts[1]);
  }
  if (!y || !ydot) refuse("must be the displacement and the velocity Y,V, as 0.5,-1");
  const auto &left = problem.system.left_wall(), &right = problem.system.right_wall();
  if (left && *y < left->position) {
    refuse(fmt::format("Y must not be behind the wall at {:g}", left->position));
  }
  if (right && *y > right->position) {
    refuse(fmt::format("Y must not be behind the wall at {:g}", right->position));
  }
  // At a barrier the motion starts away from the barrier.
  if (!barrier.is_energy() && !(*y < barrier.level || (*y == barrier.level && *ydot < 0))) {
    refuse(fmt::format("Y must be below the barrier {:g}", barrier.level));
  }
  if (const auto& lower = barrier.lower_level;
      lower && !(*y > *lower || (*y == *lower && *ydot > 0))) {
    refuse(fmt::format("Y must be above the barrier {:g}", *lower));
  }
  if (barrier.is_energy()) {
    const double energy = *ydot * *ydot / 2 + problem::EffectivePotential(problem.system)(*y);
    if (!(energy < barrier.level)) {
      refuse(fmt::format("the energy {:g} must be below the barrier {:g}", energy, barrier.level));
    }
  }
  return transform::PassageStartState{*y, *ydot};
}

// Returns the approximation by independent upward crossings at Rice's rate: the hazard nu / P, and
// exponential passage times.
FirstPassageResult rice_approximation(const FirstPassageResult& of) {
  FirstPassageResult rice{.id = "rice"};
  const double rate = of.rice_rate->value / of.probability_below->value;
  rice.hazard = {rate, 0};
  rice.mean_from_stationary = {1 / rate, 0};
  rice.times = of.times;
  for (const double t : of.times) rice.survival_from_stationary.push_back({std::exp(-rate * t), 0});
  rice.status = Status::ok;
  rice.details = "independent crossings, an approximation without an error estimate";
  return rice;
}

// Returns the passage by one method.
// @param has_automatic_times whether the times are those of an earlier method, or empty
FirstPassageResult solve_passage(const problem::Problem& problem,
                                 const SelectedFunctionalMethod& method,
                                 const transform::PassageBarrier& barrier,
                                 const std::vector<double>& times, bool has_automatic_times,
                                 const std::optional<transform::PassageStartState>& start) {
  if (method.mcs) return mcs::estimate_passage(problem, *method.mcs, barrier, times, start);
  if (method.fd) {
    return barrier.is_energy()
               ? fd_fpk::solve_energy_passage(problem, *method.fd, barrier.level, times, start)
               : fd_fpk::solve_passage(problem, *method.fd, barrier, times, start);
  }
  if (barrier.is_energy()) {
    return {.id = method.identity.id,
            .status = Status::not_offered,
            .reason =
                "the method ends the motion at a barrier of the displacement; use fd or mcs for an "
                "energy barrier"};
  }
  if (barrier.lower_level) {
    return {.id = method.identity.id,
            .status = Status::not_offered,
            .reason = "the method supports one barrier; use fd or mcs for two barriers"};
  }
  if (method.bounds) return backward::bound_passage(problem, *method.bounds, barrier.level, start);
  backward::PassageCollocationOptions collocation = *method.characteristics;
  collocation.omits_inaccurate_times = has_automatic_times;
  return backward::solve_passage(problem, collocation, barrier.level, times, start);
}

bool is_rice_approximation(const FirstPassageResult& passage) { return passage.id == "rice"; }

}  // namespace

const base::OptionsDescription<PassageOptions>& passage_option_descriptions() {
  static const auto description = with_functional_options(
      base::OptionsDescription<PassageOptions>("passage ")
          .add("displacement", &PassageOptions::displacement,
               {"B",
                "barrier: first passage of y above B; A,B: first exit from the interval (A, B)"})
          .add("energy", &PassageOptions::energy,
               {"H", "in place of --displacement: first passage of y'^2/2 + U(y) above H"},
               base::finite_numbers())
          .add("start", &PassageOptions::start,
               {"Y,V",
                "start at the displacement Y with the velocity V (default: at rest); an oscillator "
                "without a stationary density gets walls beyond the barriers"})
          .add(
              "times", &PassageOptions::times,
              {"LIST",
               "times of the survival probabilities (default: ten times up to three mean times, from "
               "the first method)"}),
      "largest relative error of finite volumes, characteristics and bounds, for status ok",
      "simulated time of the stationary process (default: until the standard error of the mean is "
      "1 %, at most about 10 s of computing); splitting of the same simulated time replaces a "
      "simulation with too few passages of one barrier; passages from a point take at most four "
      "times as long again; under noise a second simulation takes half of the total time again",
      "ids of methods: fd-kf, fd-white, fd-km4, .., characteristics, bounds, mcs, mcs-white");
  return description;
}

std::vector<std::string> walls_beyond_barriers(const PassageOptions& options) {
  const transform::PassageBarrier barrier = parse_barrier(options);
  if (!options.start || barrier.is_energy()) return {};
  const auto y = parse_finite_number(split_at_commas(*options.start).front());
  if (!y) return {};
  // A wall close to the barrier would need short sampling intervals and narrow cells.
  const double distance = barrier.lower_level
                              ? barrier.level - *barrier.lower_level
                              : std::max(std::abs(barrier.level), barrier.level - *y);
  constexpr const char* kRestitution = "0.5";
  std::vector<std::string> overrides{"wall.none=false",
                                     fmt::format("wall.right={:.6g}", barrier.level + distance),
                                     fmt::format("wall.right_restitution={}", kRestitution)};
  if (barrier.lower_level) {
    overrides.push_back(fmt::format("wall.left={:.6g}", *barrier.lower_level - distance));
    overrides.push_back(fmt::format("wall.left_restitution={}", kRestitution));
  }
  return overrides;
}

PassageStudy study_passage(const problem::Problem& problem, const PassageOptions& options,
                           const methods::ProgressListener& listener) {
  const transform::PassageBarrier barrier = parse_barrier(options);
  std::vector<double> times = parse_survival_times(options);
  const bool has_automatic_times = times.empty();
  const auto start = parse_start(problem, options, barrier);
  PassageStudy study{problem, options, {}};
  for_each_selected_method(
      problem, options, listener,
      [&](const SelectedFunctionalMethod& method) {
        study.passages.push_back(
            solve_passage(problem, method, barrier, times, has_automatic_times, start));
        // Later methods use the automatic times of the first method.
        if (times.empty()) times = study.passages.back().times;
      },
      SelectableFunctionalMethods::with_characteristics);
  const auto with_rate = std::ranges::find_if(study.passages, [](const FirstPassageResult& p) {
    return p.rice_rate && p.rice_rate->value > 0 && p.probability_below;
  });
  if (with_rate != study.passages.end()) study.passages.push_back(rice_approximation(*with_rate));
  if (barrier.is_energy()) {
    study.passages.push_back(
        {.id = "rice",
         .status = Status::not_offered,
         .reason = "the energy has no derivative at impulses and under noise, which Rice's formula "
                   "needs; use fd or mcs"});
  }
  return study;
}

bool has_converged(const PassageStudy& study) {
  std::vector<FirstPassageResult> computed;
  std::ranges::remove_copy_if(study.passages, std::back_inserter(computed), is_rice_approximation);
  return have_converged_results(computed);
}

std::string study_json_text(const PassageStudy& study, const std::string& command) {
  using results::Json;
  const auto quantities = passage_quantities(study.options);
  const std::string from_point = "from_" + start_name(study.options).key;
  Json solutions = Json::array();
  for (const FirstPassageResult& p : study.passages) {
    Json one{{"solution", p.id},
             {"status", name(p.status)},
             {"reason", p.reason},
             {"seconds", p.seconds}};
    Json error = Json::object();
    for (const auto& [key, label, quantity] : quantities) {
      const auto& value = p.*quantity;
      one[key] = value ? Json(value->value) : Json();
      error[key] = value && !is_rice_approximation(p) ? Json(value->error) : Json();
    }
    if (p.has_guaranteed_errors && p.mean_from_point) {
      const auto [middle, half_width] = *p.mean_from_point;
      one["mean_" + from_point + "_bounds"] = {{"lower", middle - half_width},
                                               {"upper", middle + half_width}};
    }
    Json survival = Json::array(), survival_error = Json::array();
    for (std::size_t k = 0; k < p.times.size(); ++k) {
      const auto at = [&](const std::vector<ValueWithError>& all, double ValueWithError::*part) {
        return k < all.size() ? Json(all[k].*part) : Json();
      };
      survival.push_back(
          {{"time", p.times[k]},
           {from_point, at(p.survival_from_point, &ValueWithError::value)},
           {"from_stationary", at(p.survival_from_stationary, &ValueWithError::value)}});
      survival_error.push_back(
          {{"time", p.times[k]},
           {from_point, at(p.survival_from_point, &ValueWithError::error)},
           {"from_stationary", at(p.survival_from_stationary, &ValueWithError::error)}});
    }
    one["survival"] = std::move(survival);
    if (!is_rice_approximation(p)) error["survival"] = std::move(survival_error);
    one["error"] = std::move(error);
    one["error_is"] =
        is_rice_approximation(p) ? Json()
        : p.has_guaranteed_errors
            ? Json("guaranteed bound")
            : Json(error_kind_text(p.has_standard_errors, p.has_kick_interval_errors));
    solutions.push_back(std::move(one));
  }
  const transform::PassageBarrier barrier = parse_barrier(study.options);
  Json passage{{"barrier", {{barrier.is_energy() ? "energy" : "displacement", barrier.level}}},
               {"solutions", std::move(solutions)}};
  if (barrier.lower_level) passage["barrier"]["lower_displacement"] = *barrier.lower_level;
  if (const auto start = parse_start(study.problem, study.options, barrier)) {
    passage["start"] = {{"y", start->y}, {"ydot", start->ydot}};
  }
  return functional_json(study.problem, "passage", passage, command);
}

std::string study_csv_text(const PassageStudy& study) {
  const auto quantities = passage_quantities(study.options);
  const std::string from_point = "survival_from_" + start_name(study.options).key;
  std::vector<StudyRecord> rows;
  for (const FirstPassageResult& p : study.passages) {
    const auto add = [&](const std::string& quantity, base::Value time,
                         const ValueWithError& value) {
      rows.push_back(
          {{"case", study.problem.name},
           {"solution", p.id},
           {"quantity", quantity},
           {"time", time},
           {"value", value.value},
           {"error", is_rice_approximation(p) ? base::Value() : base::Value(value.error)}});
    };
    for (const auto& [key, label, quantity] : quantities) {
      if (p.*quantity) add(key, {}, *(p.*quantity));
    }
    for (std::size_t k = 0; k < p.survival_from_point.size(); ++k) {
      add(from_point, p.times[k], p.survival_from_point[k]);
    }
    for (std::size_t k = 0; k < p.survival_from_stationary.size(); ++k) {
      add("survival_from_stationary", p.times[k], p.survival_from_stationary[k]);
    }
  }
  return records_csv_text(rows, "case solution quantity time value error");
}

std::string study_table_text(const PassageStudy& study, const report::TerminalTextFormat& format) {
  const transform::PassageBarrier barrier = parse_barrier(study.options);
  std::string text = report::wrap_text(report::case_title(study.problem), format.width);
  text += report::wrap_text(
      barrier.lower_level
          ? fmt::format(
                "first exit of y from ({:g}, {:g}); survival: probability that y has stayed "
                "in the interval",
                *barrier.lower_level, barrier.level)
          : fmt::format(
                "first passage of {0} above {1:g}; survival: probability that {0} has stayed below",
                barrier_quantity_text(barrier), barrier.level),
      format.width);
  const auto quantities = passage_quantities(study.options);
  std::vector<StudyTableColumn> columns{{"", "", "what", "", report::kAlwaysShown, true}};
  std::vector<StudyRecord> rows;
  for (const auto& named : quantities) rows.push_back({{"what", std::string(named.name)}});
  const auto with_times = std::ranges::find_if(
      study.passages, [](const FirstPassageResult& p) { return !p.times.empty(); });
  const std::vector<double> times =
      with_times == study.passages.end() ? std::vector<double>{} : with_times->times;
  for (const std::string& start : {start_name(study.options).text, std::string("stationary")}) {
    for (const double t : times) {
      rows.push_back({{"what", fmt::format("survival from {}, t = {:g}", start, t)}});
    }
  }
  for (const FirstPassageResult& p : study.passages) {
    if (!p.hazard && !p.mean_from_stationary && !p.mean_from_point) continue;
    constexpr double kSmallError = 1e-5;  // a relative error that six digits do not show
    const bool is_precise =
        !is_rice_approximation(p) && p.hazard && p.hazard->error < kSmallError * p.hazard->value;
    append_value_columns(p.id, "value", p.has_standard_errors && !p.has_kick_interval_errors,
                         columns, is_precise ? "{:.9g}" : "{:.6g}");
    if (is_rice_approximation(p)) columns.pop_back();  // without errors
    std::size_t row = 0;
    const auto add = [&](const ValueWithError* value) {
      if (value != nullptr) {
        rows[row].push_back({p.id, value->value});
        rows[row].push_back({p.id + "-error", value->error});
      }
      ++row;
    };
    for (const auto& named : quantities) {
      const auto& value = p.*(named.quantity);
      add(value ? &*value : nullptr);
    }
    for (const auto* survival : {&p.survival_from_point, &p.survival_from_stationary}) {
      for (std::size_t k = 0; k < times.size(); ++k) {
        add(k < survival->size() ? &(*survival)[k] : nullptr);
      }
    }
  }
  std::erase_if(rows, [](const StudyRecord& row) { return row.size() == 1; });
  if (columns.size() > 1) text += records_table_text(rows, columns, format);
  for (const FirstPassageResult& p : study.passages) {
    const std::string seconds =
        is_rice_approximation(p) ? "" : fmt::format(" ({:.1f} s)", p.seconds);
    text += report::wrap_text(solution_status_line(p.id, p.status, p.reason) + p.details + seconds,
                              format.width, 2);
  }
  return text;
}

namespace {

// Returns the panel of the mean times from all starts below the barrier.
report::FigurePanel mean_time_panel(const FirstPassageResult& passage) {
  const transform::MeanPassageTimeMap& map = *passage.mean_passage_times_by_start;
  // A picture of 800 x 300 pixels resolves these cells, which are of equal size.
  constexpr std::size_t kColumns = 200, kRows = 100;
  const auto range = [](const std::vector<double>& edges) {
    return std::array{edges.front(), edges.back()};
  };
  const std::array y_range = range(map.y_edges), v_range = range(map.v_edges);
  // Returns the cells of the grid at the centres of equal cells.
  const auto cells_at_centres = [](const std::vector<double>& edges, std::size_t count) {
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k < count; ++k) {
      const double centre = std::lerp(edges.front(), edges.back(),
                                      (static_cast<double>(k) + 0.5) / static_cast<double>(count));
      cells.push_back(
          static_cast<std::size_t>(std::ranges::upper_bound(edges, centre) - edges.begin() - 1));
    }
    return cells;
  };
  const auto y_cells = cells_at_centres(map.y_edges, kColumns),
             v_cells = cells_at_centres(map.v_edges, kRows);
  std::vector<double> values;
  for (const std::size_t j : v_cells) {
    for (const std::size_t i : y_cells) {
      // Near the jump of T the averages of the finite volumes may be slightly negative.
      values.push_back(std::max(0.0, map.averages[i * (map.v_edges.size() - 1) + j]));
    }
  }
  const double longest = *std::ranges::max_element(values);
  return {.title = fmt::format(
              "mean time to the passage, start at ({{/:Italic y}}, {{/:Italic y}}'), {}",
              report::escape_enhanced_text(passage.id)),
          .x = {"{/:Italic y}", y_range[0], y_range[1]},
          .y = {"{/:Italic y}'", v_range[0], v_range[1]},
          .map = report::FigureHeatMap{.x_range = y_range,
                                       .y_range = v_range,
                                       .columns = kColumns,
                                       .values = std::move(values),
                                       .colour_axis = {"mean time {/:Italic T}", 0, longest},
                                       .colours = {std::begin(report::kSequentialColours),
                                                   std::end(report::kSequentialColours)}}};
}

}  // namespace

report::Figure study_figure(const PassageStudy& study) {
  std::vector<report::FigureSeries> series;
  const auto methods =
      methods_selected_by_list(study.options, SelectableFunctionalMethods::with_characteristics);
  for (const FirstPassageResult& p : study.passages) {
    if (p.survival_from_stationary.empty()) continue;
    const auto method = find_method(methods, p.id);
    report::FigureSeries one = report::make_empty_figure_series(
        p.id, method == methods.end()
                  ? transform::PlotStyle{.colour = "#D55E00", .dash = "(6,3)", .symbol = ""}
                  : method->identity.plot_style);
    const auto add = [&](double time, const ValueWithError& survival) {
      one.points.push_back(figure_point_with_error_interval(time, survival.value, survival.error,
                                                            p.has_standard_errors));
    };
    add(0, {1, 0});
    for (std::size_t k = 0; k < p.times.size(); ++k) add(p.times[k], p.survival_from_stationary[k]);
    series.push_back(std::move(one));
  }
  if (series.empty()) return {};
  const transform::PassageBarrier barrier = parse_barrier(study.options);
  report::FigurePanel panel{
      .title = fmt::format("probability that {} stays {}, stationary start",
                           barrier_quantity_text(barrier), survival_text(barrier)),
      .x = report::linear_axis("{/:Italic t}", series, &report::FigurePoint::x),
      .y = report::logarithmic_axis("survival probability", series, &report::FigurePoint::y),
      .series = series};
  report::Figure figure{
      .title = report::problem_title_parts(study.problem), .panels = {panel}, .columns = 1};
  const auto with_map = std::ranges::find_if(study.passages, [](const FirstPassageResult& p) {
    return p.mean_passage_times_by_start.has_value();
  });
  if (with_map != study.passages.end()) {
    figure.panels.push_back(mean_time_panel(*with_map));
  }
  return figure;
}

}  // namespace fpkcheck::study
